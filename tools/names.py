"""A name of a type means one thing: two headers that define one name, each in its own namespace, are refused."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "playhouse"

# At the start of a line, where types of a namespace are: nested ones are indented. Declarations end in a semicolon.
DEFINITION = re.compile(r"^(?:(?:class|struct|union|enum(?: class)?) (?:alignas\(\w+\) )?(\w+)(?: final)?(?: :[^;]*)?(?: \{.*)?|using (\w+) =.*)$", re.M)


def definitions(path):
    """(line, name) of each type that a header defines in a namespace."""
    text = path.read_text()
    for found in DEFINITION.finditer(text):
        yield text.count("\n", 0, found.start()) + 1, found[1] or found[2]


def defined_twice():
    first = {}  # where each name is
    for path in sorted(SOURCE.rglob("*.h")):
        if "generated" in path.parts:
            continue
        for number, name in definitions(path):
            where = f"{path.relative_to(ROOT)}:{number}"
            other = first.setdefault(name, where)
            if other.rpartition(":")[0] != str(path.relative_to(ROOT)):
                yield f"{where}: {name} is another thing in {other}: a name that says which (docs/conventions.md)"
