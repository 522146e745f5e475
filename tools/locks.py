"""docs/locks.md lists every mutex of the program, and nothing else."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "playhouse"
PAGE = ROOT / "docs/locks.md"

MUTEX = re.compile(r"^(\s*)(?:static |mutable |inline )*std::(?:recursive_|shared_|timed_)*mutex (\w+)[;{]")
SCOPE = re.compile(r"^(\s*)(?:class|struct|namespace) (\w[\w:]*)[^;]*$|^(\s*)[\w:<>&* ]+?(\w+)\([^;]*\) (?:const )?\{$")
ROW = re.compile(r"^\| `([\w:]+)`")


def mutexes():
    """(file:line, "Scope::name") of each; its scope is the class or function that is less indented."""
    for path in sorted(SOURCE.rglob("*")):
        if path.suffix not in (".h", ".cc") or path.stem.endswith(("_test", "_bench", "_fuzz")) or "testing" in str(path):
            continue
        lines = path.read_text().splitlines()
        for number, line in enumerate(lines):
            found = MUTEX.match(line)
            if found:
                yield f"{path.relative_to(ROOT)}:{number + 1}", f"{_scope(lines[:number], len(found[1]))}::{found[2]}"


def _scope(before, indent):
    for line in reversed(before):
        found = SCOPE.match(line)
        if found and len(found[1] if found[2] else found[3]) < indent:
            return (found[2] or found[4]).rpartition("::")[2]
    return ""


def findings():
    listed = {row[1] for row in map(ROW.match, PAGE.read_text().splitlines()) if row}
    short = {"::".join(name.split("::")[-2:]) for name in listed}
    seen = set()
    for where, name in mutexes():
        seen.add(name)
        if name not in short:
            yield f"{where}: {name} is not in {PAGE.relative_to(ROOT)}"
    for name in sorted(listed):
        if "::".join(name.split("::")[-2:]) not in seen:
            yield f"{PAGE.relative_to(ROOT)}:1: there is no mutex {name}"
