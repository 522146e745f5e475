"""docs/locks.md lists every mutex of the program, and nothing else; the table of threads in ARCHITECTURE.md names
every file that starts one."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "playhouse"
PAGE = ROOT / "docs/locks.md"
MAP = ROOT / "ARCHITECTURE.md"

MUTEX = re.compile(r"^(\s*)(?:static |mutable |inline )*std::(?:recursive_|shared_|timed_)*mutex (\w+)[;{]")
ANY_MUTEX = re.compile(r"\bstd::\w*mutex\b(?!\s*[>&*])|(?:array|vector|deque|_ptr)<\s*std::\w*mutex\b")
SCOPE = re.compile(r"^(\s*)(?:class|struct|namespace) (\w[\w:]*)[^;]*$|^(\s*)[\w:<>&* ]+?(\w+)\([^;]*\) (?:const )?\{$")
ROW = re.compile(r"^\| `([\w:]+)`")
START = re.compile(r"std::j?thread(?: \w+)?\(|avahi_threaded_poll_start\(")
NUMBERS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve", "thirteen", "fourteen",
            "fifteen", "sixteen"]
STARTED_IN = re.compile(r"`([\w/]+)\.h`")  # in the table of threads


def _sources():
    """Of the program: without tests and benches."""
    for path in sorted(SOURCE.rglob("*")):
        name = str(path.relative_to(SOURCE))
        if path.suffix in (".h", ".cc") and not re.search(r"_test\.|_fuzz\.|bench|testing", name):
            yield path


def mutexes():
    """(file:line, module, "Scope::name") of each; its scope is the class or function that is less indented. The name
    is empty for a declaration that is not one mutex on a line of its own."""
    for path in _sources():
        lines = path.read_text().splitlines()
        for number, line in enumerate(lines):
            found = MUTEX.match(line)
            where, module = f"{path.relative_to(ROOT)}:{number + 1}", path.relative_to(SOURCE).parts[0]
            if found:
                yield where, module, f"{_scope(lines[:number], len(found[1]))}::{found[2]}"
            elif ANY_MUTEX.search(line.split("//")[0]):
                yield where, module, ""


def _scope(before, indent):
    for line in reversed(before):
        found = SCOPE.match(line)
        if found and len(found[1] if found[2] else found[3]) < indent:
            return (found[2] or found[4]).rpartition("::")[2]
    return ""


def findings():
    return [*lock_findings(), *thread_findings()]


def thread_findings():
    table = MAP.read_text().partition("| thread | does |")[2].partition("\n\n")[0]
    listed = set(STARTED_IN.findall(table))
    rows = max(table.count("\n|") - 1, 0)  # without the line below the head
    kinds = f"{NUMBERS[rows]} kinds of threads"
    if rows and kinds not in MAP.read_text():
        yield f"{MAP.name}:1: the table has {kinds}"
    for path in _sources():
        name = str(path.relative_to(SOURCE).with_suffix(""))
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if START.search(line) and name not in listed:
                yield f"{path.relative_to(ROOT)}:{number}: {name}.h is not in the table of threads in {MAP.name}"


def lock_findings():
    """A row names module, class or function, and mutex; rows of base/, whose names are in no namespace of its own, the
    latter two."""
    listed = {row[1] for row in map(ROW.match, PAGE.read_text().splitlines()) if row}
    seen = set()
    for where, module, name in mutexes():
        if not name:
            yield f"{where}: write one mutex a line, so that tools/threads.py finds it"
            continue
        rows = {row for row in listed if row == name or (row.startswith(module + "::") and row.endswith("::" + name)) or
                (module == "base" and row.endswith("::" + name))}
        seen |= rows
        if not rows:
            yield f"{where}: {module}::{name} is not in {PAGE.relative_to(ROOT)}"
    for name in sorted(listed - seen):
        yield f"{PAGE.relative_to(ROOT)}:1: there is no mutex {name}"
