"""Text of a word for readers: form, unit, default and limits, shared by the tables in C++ and the reference pages."""

from __future__ import annotations

from codegen.kind_words import Word

SI = {"ms": "s", "deg": "rad"}


def form_text(word: Word) -> str:
    """Syntax of the value in a file: `[x y z]`, `"diff" | "omni" | "car"`."""
    if word.type == "choice":
        return " | ".join(f'"{v.word}"' for v in word.values)
    if word.type == "choices":
        return "[" + " ".join(f"({form_text(choice)})" for choice in word.choices) + "]"
    return f"[{word.form}]" if word.form else ""


def unit_text(word: Word, inside: bool = False) -> str:
    """Unit in the file, or with `inside` of the member; a single one if all are equal."""
    units = word.units()
    if inside:
        units = [_inside(unit) for unit in units]
    if len(set(units)) <= 1:
        units = units[:1]
    if len(units) == 8:  # bounds: a minimum and a maximum have the same
        units = units[::2]
    return "" if units in ([], ["1"]) else ", ".join(units)


def _inside(unit: str) -> str:
    base, slash, rate = unit.partition("/")
    return SI.get(base, base) + slash + rate


def default_text(word: Word) -> str:
    """In world-file syntax; "" if the definition has it in words."""
    value = word.default
    if word.default_text or value is None:
        return ""
    if word.type in ("text", "choice"):
        return f'"{value}"'
    if word.type == "choices":
        return "[" + " ".join(f'"{v}"' for v in value) + "]"
    if isinstance(value, list):
        return "[" + " ".join(_number(v) for v in value) + "]"
    return _number(value)


def _number(value: float) -> str:
    return repr(value) if value != round(value, 6) else f"{value:g}"


def doc_text(word: Word) -> str:
    """The description, with the meanings of the values of a choice."""
    told = [f'"{v.word}": {v.doc}' for choice in [word, *word.choices] for v in choice.values if v.doc]
    return word.doc + (" " + "; ".join(told) + "." if told else "")


def limits_text(word: Word) -> str:
    if word.ascending_from is not None:
        return " <= ".join([f"{word.ascending_from}", *(p.name for p in word.parts)])
    if word.max is not None:
        return f"from {word.min} to {word.max}"
    if word.above is not None:
        return "above 0"
    return {None: "", 0: "not negative"}.get(word.min, f"at least {word.min}")
