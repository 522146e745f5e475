"""How people read a word: its form, unit, default and limits. The tables in C++ and the reference pages both have it so."""

from __future__ import annotations

from codegen.kind_words import UNITS, Word

SI = {"m": "m", "deg": "rad"}


def form_text(word: Word) -> str:
    """What a file has behind the word: `[x y z]`, `"diff" | "omni" | "car"`."""
    if word.type == "choice":
        return " | ".join(f'"{v.word}"' for v in word.values)
    if word.type == "choices":
        return "[" + " ".join(f"({form_text(choice)})" for choice in word.choices) + "]"
    return f"[{word.form}]" if word.form else ""


def unit_text(word: Word, inside: bool = False) -> str:
    """Of the file by default, or `inside` of the member; one for all where they are the same."""
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
    return SI[base] + slash + rate if base in SI and slash else UNITS.get(unit, unit)


def default_text(word: Word) -> str:
    """As a file would say it; "" where the definition tells it in words."""
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
    """With what each word of a choice means."""
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
