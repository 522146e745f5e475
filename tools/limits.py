"""Limits of playhouse/base: which modules heed them, and the values that documents give."""

import ast
import pathlib
import re

import module_graph

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "playhouse"
HEADERS = ("base/limits.h", "base/mesh_limits.h")
EVERYWHERE = {"app", "house"}  # modules that link everything

DEFINED = re.compile(r"inline constexpr [\w:]+ (k\w+)\s+=\s+([^;,]+)(?:, (k\w+)\s+=\s+([^;,]+))?;")
PART = re.compile(r"^// .*; heeded by ([\w, ]+)\.$", re.M)
WORD = re.compile(r"\bk[A-Z]\w+")
# In documents: `kName` and a value behind it, with or without parentheses; a value and (`kName`) close behind it; or a
# row of a table that begins with names, and its values in their order.
VALUE = r"(\d[\d,]*(?:\.\d+)?)(?: (KiB|MiB|GiB))?"
AFTER = re.compile(rf"`(k[A-Z]\w+)` \(?{VALUE}\b")
BEFORE = re.compile(rf"\b{VALUE}[^`.;|(\d]{{0,40}}\(`(k[A-Z]\w+)`\)")
ROW = re.compile(r"^\| (`k[A-Z]\w+`(?:, `k[A-Z]\w+`)*) \| (\d.*)$")
UNITS = {"": 1, "KiB": 1 << 10, "MiB": 1 << 20, "GiB": 1 << 30}


def values():
    """Of each limit, by its name."""
    found = {}
    for header in HEADERS:
        text = re.sub(r"\s*//.*", "", (SOURCE / header).read_text())
        for first, one, second, two in DEFINED.findall(text):
            for name, value in ((first, one), (second, two)):
                if name:
                    found[name] = _number(value, found)
    return found


def _number(expression, known):
    """Of sums, differences and shifts of literals, and of limits before it."""
    plain = re.sub(r"std::size_t\{(\d+)\}", r"\1", re.sub(r"\b(\d+)u\b", r"\1", expression))
    plain = WORD.sub(lambda name: str(known[name[0]]), plain)
    tree = ast.parse(" ".join(plain.split()), mode="eval").body

    def of(node):
        if isinstance(node, ast.Constant):
            return node.value
        left, right = of(node.left), of(node.right)
        return {ast.LShift: lambda: left << right, ast.Sub: lambda: left - right, ast.Add: lambda: left + right, ast.RShift: lambda: left >> right}[type(node.op)]()

    return of(tree)


def _defined(text):
    return {name for line in text.splitlines() if line.startswith("inline constexpr ") for name in re.findall(r"\b(k[A-Z]\w+)\s+=", line)}


def findings(documents):
    return [*unused(), *wrong_owners(), *(finding for name in sorted(documents) for finding in wrong_values(name))]


def _heeded():
    """Module -> how often its files, without tests, name each constant."""
    found = {}
    for path in SOURCE.rglob("*"):
        if path.suffix in (".h", ".cc", ".inc") and not module_graph.is_test(path):
            counts = found.setdefault(path.relative_to(SOURCE).parts[0], {})
            for word in WORD.findall(path.read_text()):
                counts[word] = counts.get(word, 0) + 1
    return found


def unused():
    """Limits that no code of the program heeds."""
    heeded = _heeded()
    for header in HEADERS:
        for number, line in enumerate((SOURCE / header).read_text().splitlines(), 1):
            for name in _defined(line):
                if sum(counts.get(name, 0) for counts in heeded.values()) < 2:
                    yield f"playhouse/{header}:{number}: nothing heeds {name}"


def wrong_owners():
    """Parts of the headers that name other modules than those that heed their limits."""
    heeded = _heeded()
    for header in HEADERS:
        text = (SOURCE / header).read_text()
        parts = list(PART.finditer(text))
        for part, end in zip(parts, [each.start() for each in parts[1:]] + [len(text)]):
            names = _defined(text[part.end():end])
            owners = {module for module, counts in heeded.items() if names & counts.keys()} - EVERYWHERE - {"base"}
            if owners != set(part[1].split(", ")):
                line = text.count("\n", 0, part.start()) + 1
                yield f"playhouse/{header}:{line}: these limits are heeded by {', '.join(sorted(owners))}"


def wrong_values(name):
    """Limits of a document that have another value, or are none of the program."""
    limits = values()
    for number, line in enumerate((ROOT / name).read_text().splitlines(), 1):
        told = AFTER.findall(line) + [(limit, value, unit) for value, unit, limit in BEFORE.findall(line)]
        if row := ROW.match(line):
            told += [(limit, *value) for limit, value in zip(WORD.findall(row[1]), re.findall(VALUE, row[2]))]
        for limit, value, unit in told:
            if limit in limits and float(value.replace(",", "")) * UNITS[unit] != limits[limit]:
                yield f"{name}:{number}: {limit} is {limits[limit]}"
        for limit in re.findall(r"`(k[A-Z]\w+)`", line):
            if limit not in limits and not _is_constant(limit):
                yield f"{name}:{number}: there is no {limit}"


def _is_constant(name):
    folders = (SOURCE, ROOT / "web/src")
    return name == "kName" or any(re.search(rf"\b{name}\b", path.read_text()) for folder in folders for path in folder.rglob("*")
                                  if path.suffix in (".h", ".cc", ".ts"))
