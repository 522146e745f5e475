"""The graph of modules, as CMake links it: DEPS of each playhouse/NAME/CMakeLists.txt is its only definition.
A module may include itself and whatever it links, directly or not."""

import functools
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "playhouse"
MAP = ROOT / "ARCHITECTURE.md"

INCLUDE = re.compile(r'^\s*#\s*include\s+"playhouse/(\w+)/')
MODULE = re.compile(r"playhouse_module\((\w+)([^)]*)\)")
LINK = re.compile(r"target_link_libraries\((\w+)([^)]*)\)")
ROW = re.compile(r"^(\| `playhouse/(\w+)` \|.*\|)\s*([^|]*?)\s*\|$")  # of the table of MAP
FOLDER_FILES = 45  # by hand: what a reader takes in at a glance
EVERYTHING = "everything"  # in the table, of the module that wires all others


def _named(words):
    """Modules among words of CMake. The log and the version are libraries of their own in base/."""
    return {"base" if word in ("playhouse_log", "playhouse_version") else word.removeprefix("playhouse_")
            for word in words.split() if word.startswith("playhouse_")}


@functools.cache
def links():
    """What each target links directly: of modules by their names, of test programs as NAME_test."""
    graph = {}
    for path in sorted(SOURCE.glob("*/CMakeLists.txt")):
        text = re.sub(r"#.*", "", path.read_text())
        for name, words in MODULE.findall(text):
            deps = re.split(r"(?<![\w:])[A-Z]{3,}(?![\w:])", words.partition("DEPS")[2])[0]
            graph[name] = _named(deps)
        for target, words in LINK.findall(text):
            graph.setdefault(target.removeprefix("playhouse_"), set()).update(_named(words))
    return graph


def modules():
    return sorted(path.parent.name for path in SOURCE.glob("*/CMakeLists.txt"))


@functools.cache
def reachable(target):
    """All modules that a target links, directly or not. A circle is an error."""
    found = set()
    for other in links().get(target, ()):
        if other in links():
            found |= {other} | reachable(other)
    return frozenset(found)


def is_test(path):
    """Tests, and what only they include."""
    return path.stem.endswith(("_test", "_bench", "_fuzz")) or "testing" in path.parts or path.name.startswith("testing")


def wrong_includes(path):
    """(line, module, other) of each include of a module that this file's own does not link."""
    module = path.relative_to(SOURCE).parts[0]
    allowed = {module} | reachable(module)
    if is_test(path):
        allowed |= reachable(f"{module}_test")
    for number, line in enumerate(path.read_text().splitlines(), 1):
        found = INCLUDE.match(line)
        if found and found[1] not in allowed:
            yield number, module, found[1]


def large_folders():
    """Folders with more files than FOLDER_FILES, without generated ones."""
    for folder in [SOURCE, *sorted(path for path in SOURCE.rglob("*") if path.is_dir() and path.name != "generated")]:
        files = sum(path.is_file() for path in folder.iterdir())
        if files > FOLDER_FILES:
            yield f"{folder.relative_to(ROOT)}:1: {files} files in one folder: {FOLDER_FILES} at most (docs/adr/0024)"


def in_table(module):
    """What the table of ARCHITECTURE.md says of a module: what it links and nothing else of that links for it."""
    if module == "app":
        return EVERYTHING
    direct = {other for other in links()[module] if other in modules()}
    return ", ".join(sorted(other for other in direct if not any(other in reachable(third) for third in direct)))


def table_findings(write=False):
    """Rows of the table that say something else than CMake does; with `write` they are mended instead."""
    lines, findings, seen = MAP.read_text().splitlines(), [], set()
    for number, line in enumerate(lines):
        row = ROW.match(line)
        if not row:
            continue
        if row[2] not in modules():
            findings.append(f"{MAP.name}:{number + 1}: there is no module {row[2]}")
            continue
        seen.add(row[2])
        should = in_table(row[2])
        if row[3] == should:
            continue
        findings.append(f"{MAP.name}:{number + 1}: {row[2]} links {should or 'no module'}" +
                        ("" if write else ": tools/tidy.py --write-table"))
        lines[number] = f"{row[1]} {should} |" if should else f"{row[1]} |"
    findings += [f"{MAP.name}:1: no row for playhouse/{module}" for module in modules() if module not in seen]
    if write:
        MAP.write_text("\n".join(lines) + "\n")
    return findings
