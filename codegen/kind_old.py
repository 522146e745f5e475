"""Words and types of Stage 1 to 3 and their replacements: `[old]` and `[old_types]` of kinds/*.toml.

An entry is a text, what to write instead, of what has no effect (or, of a type, is an error), or a table:

    laser_return = {instead = "write ranger_return", to = ["ranger_return"], values = {0 = -1}}
    view = {instead = "write sensor( range [min max] fov degrees )", part = "sensor", to = ["range.0", "range.1", "fov"]}
    scount = {instead = "the sensor( ) entities are counted", part = "sensor", counts = true}
    polygon = {instead = "write block( ... )", part = "block", nested = true}
    laser = {instead = "write ranger( sensor( ... ) )", type = "ranger", part = "sensor", part_words = {samples = 180}}

`to` holds a word for each value, `word.1` for its second number; one word alone has them all. With `part` these are words of parts:
old[1] of the second, old without a number of all. `counts` tells how many parts there are; `nested` is polygon[1].points of the
second; `by_hand` is for what playhouse/scene/text/old_words.cc knows. `words` and `part_words` are what an entity of an old type, or a part that an old word makes, says where the file does not; of a
`type` that is "" nothing is left.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from codegen.checks import SchemaError, keys, one_of, typed

KEY_TYPES = {"instead": str, "part": str, "type": str, "to": list, "values": dict, "words": dict, "part_words": dict,
             "counts": bool, "nested": bool, "by_hand": bool}


@dataclass
class OldWord:
    name: str
    instead: str                                          # replacement for the author; "" without one
    how: str = "none"                                     # none, words, count, nested, by hand
    part: str = ""                                        # part with the words `to`; "" the entity itself
    to: list[str] = field(default_factory=list)           # "" for a value without a replacement
    values: dict[str, str] = field(default_factory=dict)  # replaced values
    part_words: dict[str, str] = field(default_factory=dict)  # further words of each part, unless in the file


@dataclass
class OldType:
    name: str
    instead: str
    type: str | None = None  # replacement; "" ignored; None an error
    part: str = ""           # a part of which it has at least one
    words: dict[str, str] = field(default_factory=dict)
    part_words: dict[str, str] = field(default_factory=dict)


def old_word(where: str, name: str, entry: Any) -> OldWord:
    if isinstance(entry, str):
        return OldWord(name, entry)
    _check(where, entry, {"part", "to", "values", "counts", "nested", "by_hand", "part_words"})
    ways = [key for key in ("to", "counts", "nested", "by_hand") if entry.get(key)]
    if len(ways) != 1:
        raise SchemaError(f"{where}: exactly one of to, counts, nested and by_hand is expected")
    if ways[0] in ("counts", "nested") and "part" not in entry:
        raise SchemaError(f"{where}: {ways[0]} is about parts, and there is no part")
    how = {"to": "words", "counts": "count", "nested": "nested", "by_hand": "by hand"}[ways[0]]
    return OldWord(name, entry["instead"], how, entry.get("part", ""), entry.get("to", []), _texts(entry.get("values", {})),
                   _texts(entry.get("part_words", {})))


def old_type(where: str, name: str, entry: Any) -> OldType:
    if isinstance(entry, str):
        return OldType(name, entry)
    _check(where, entry, {"type", "part", "words", "part_words"})
    if "type" not in entry:
        raise SchemaError(f"{where}: type is missing")
    return OldType(name, entry["instead"], entry["type"], entry.get("part", ""), _texts(entry.get("words", {})),
                   _texts(entry.get("part_words", {})))


def check_old(kinds: Any, kind: Any) -> None:
    """Checks that replacements of old words and types exist."""
    for word in kind.old:
        where = f"{kind.source}: old {word.name}"
        owner = _owner(kinds, where, kind, word.part)
        for name in [*(to.partition(".")[0] for to in filter(None, word.to)), *word.part_words]:
            _known(kinds, where, owner, name)
    for old in filter(lambda old: old.type, kind.old_types):
        where = f"{kind.source}: old_types {old.name}"
        one_of(where, "type", old.type, [k.name for k in kinds.models()])
        for words, part in ((old.words, ""), (old.part_words, old.part)):
            owner = _owner(kinds, where, kinds.find(old.type), part)
            for name in words:
                _known(kinds, where, owner, name)


def _check(where: str, entry: Any, optional: set[str]) -> None:
    if not isinstance(entry, dict):
        raise SchemaError(f"{where}: a text or a table is expected")
    keys(where, entry, {"instead"}, optional)
    typed(where, entry, KEY_TYPES)


def _texts(table: dict[str, Any]) -> dict[str, str]:
    return {name: str(value) for name, value in table.items()}


def _owner(kinds: Any, where: str, kind: Any, part: str) -> Any:
    if not part:
        return kind
    one_of(where, "part", part, [k.name for k in kinds.all if k.entity == "part" and k.inside in (kind.name, "model")])
    return kinds.find(part)


def _known(kinds: Any, where: str, owner: Any, name: str) -> None:
    base = kinds.find("model") if owner.entity == "model" else owner
    one_of(where, "word", name, [w.name for k in (owner, base) for w in k.words] + owner.silent + base.silent)
