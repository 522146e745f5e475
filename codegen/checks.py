"""Checks common to all definitions; a `SchemaError` is the message for the author."""

from __future__ import annotations

import difflib


class SchemaError(Exception):
    """An invalid definition: a one-line message."""


def one_of(where: str, what: str, value, known) -> None:
    """Refuses an unknown word, with the nearest known one."""
    known = [str(k) for k in known]
    if value in known:
        return
    near = difflib.get_close_matches(str(value), known, 1)
    hint = f" (did you mean {near[0]!r}?)" if near else f": it is one of {', '.join(known)}"
    raise SchemaError(f"{where}: unknown {what} {value!r}{hint}")


def keys(where: str, row: dict, needed: set[str], optional: set[str]) -> None:
    for key in sorted(needed - row.keys()):
        raise SchemaError(f"{where}: {key} is missing")
    for key in sorted(row.keys()):
        one_of(where, "key", key, sorted(needed | optional))


def typed(where: str, row: dict, types: dict) -> None:
    """Refuses values of a wrong type; keys that are not in `types` are ignored."""
    names = {str: "a text", bool: "true or false", list: "a list", dict: "a table", int: "a whole number"}
    for key, value in row.items():
        wanted = types.get(key, object)
        if not isinstance(value, wanted) or (isinstance(value, bool) and wanted not in (bool, object)):
            raise SchemaError(f"{where}: {key} {value!r} is not {names.get(wanted, 'a number')}")


def documented(where: str, text: str) -> None:
    if not isinstance(text, str) or not text.strip().endswith("."):
        raise SchemaError(f"{where}: doc must be a sentence")


def unique(where: str, what: str, values: list) -> None:
    seen = set()
    for value in values:
        if value in seen:
            raise SchemaError(f"{where}: {what} {value!r} is there twice")
        seen.add(value)
