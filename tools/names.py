"""One word, one meaning (docs/conventions.md): a type has a name of its own, within other types too, types that the
glossary names exist, and nothing is called by a word for which the glossary has another."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "playhouse"

# Types of namespaces and, indented, those within others. Declarations end in a semicolon.
DEFINITION = re.compile(r"^ *(?:template <.*> )?(?:(?:class|struct|union|enum(?: class)?) (?:\[\[\w+\]\] )?(?:alignas\(\w+\) )?(?:\w+::)*(\w+)(?: final)?(?:\s+:[^;{]*)?\s*\{|using (\w+)\s*=\s*([^;]*);)", re.M)
TEXT = re.compile(r"""'\\?.'|"(?:[^"\\]|\\.)*\"""")  # what the program says, and names of headers
OTHERS = re.compile(r"\b(?:bt[A-Z]\w*::\w+|m_\w+|(?!k[A-Z])[a-z]+[A-Z]\w*)")


def definitions(path):
    """(line, name, of) of each type that a header defines; `of` is what an alias is one of, else None."""
    text = path.read_text()
    for found in DEFINITION.finditer(text):
        of = found[3] and " ".join(found[3].split())
        yield text.count("\n", 0, found.start()) + 1, found[1] or found[2], of


def defined_twice():
    first = {}  # where each name is, and what it is an alias of
    for path in sorted(SOURCE.rglob("*.h")):
        if "generated" in path.parts:
            continue
        for number, name, of in definitions(path):
            if of and of.rpartition("::")[2] == name:
                continue  # the same thing, from another scope
            where = f"{path.relative_to(ROOT)}:{number}"
            other, other_of = first.setdefault(name, (where, of))
            if other != where and (of is None or of != other_of):
                yield f"{where}: {name} is another thing in {other}: a name that says which (docs/conventions.md)"


def glossary():
    """(line, cells) of each row of the tables under "Words"."""
    page = ROOT / "docs/conventions.md"
    lines = page.read_text().splitlines()
    begin = lines.index("## Words")
    for number, line in enumerate(lines[begin + 1:], begin + 2):
        if line.startswith("## "):
            return
        if line.startswith("| "):
            yield number, [cell.strip() for cell in line.strip("|").split("|")]


def unknown_types():
    known = {name for path in SOURCE.rglob("*.h") for _, name, _ in definitions(path)}
    for number, cells in glossary():
        for name in re.findall(r"`([A-Z]\w+)`", cells[1]):
            if name not in known:
                yield f"docs/conventions.md:{number}: no header defines {name}"


def refused():
    """What to write instead of each word, or pair of words."""
    rows = [cells for _, cells in glossary()]
    return {word: cells[1] for cells in rows[rows.index(["not", "but"]) + 1:] for word in re.split(", ", cells[0]) if set(word) != {"-"}}


def spelled_out(line):
    """Identifiers and comments of a line as words: kRaySpan is "k ray span". Names of libraries, as of Bullet, are left out."""
    own = OTHERS.sub("", TEXT.sub('""', line))
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|[_-]", " ", own).lower()


def refused_words(path, instead):
    """"file:line: what" of each word of `instead` in identifiers and comments of a file."""
    pattern = re.compile(r"\b(?:" + "|".join(instead) + r")\b")
    for number, line in enumerate(path.read_text().splitlines(), 1):
        for word in pattern.findall(spelled_out(line)):
            yield f"{path.relative_to(ROOT)}:{number}: {word}: say {instead[word]} (docs/conventions.md)"
