"""Loads and validates the commands of viewers, viewer/commands.toml."""

from __future__ import annotations

import json
import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

from codegen.checks import SchemaError, documented, keys, one_of, typed, unique

# Required right of a command, and its holders as named on the page (playhouse/web_server/guests.h).
RIGHTS = {"anybody": "every viewer", "drives": "viewers with the right to drive", "joins": "viewers with the right to join", "manages": "viewers with the right to manage"}
WAVE = "*waves*"         # text that makes a person wave: from a page, by `speech` or by `say` in a world file
PERSON_LETTERS = 24     # maximum length of a name
PERSON_SETS = ("A-Za-z", r"A-Za-z0-9_\-")   # first character and further ones, as regular-expression sets
PERSON_RULE = "letters, digits, - and _, the first one a letter"


@dataclass(frozen=True)
class Type:
    cpp: str            # with the default value
    read: str           # function of playhouse/replicate/command_members.h, and its argument after the key
    typescript: str
    example: object
    range: str = ""     # for the reference page
    optional: bool = False


TYPES = {
    "count": Type("std::uint32_t {} = 0", "count", "number", 0, "a whole number"),
    "count or nothing": Type("std::uint32_t {} = 0", "count_or_none", "number", 7, "a whole number; may be left out: 0", optional=True),
    "tick": Type("std::uint64_t {} = 0", "tick", "number", 120, "a whole number"),
    "model": Type("world::ModelId {}", "model", "number", 3, "the id of a model"),
    "model or null": Type("std::optional<world::ModelId> {}", "model_or_null", "number | null", 3, "the id of a model, or `null`"),
    "metres": Type("double {} = 0", "within:1e6", "number", 1, "m, -10⁶ to 10⁶"),
    "radians": Type("double {} = 0", "within:1e6", "number", 0.5, "rad, -10⁶ to 10⁶"),
    "velocity": Type("double {} = 0", "within:100", "number", 0, "m/s or rad/s, -100 to 100"),
    "speed": Type("double {} = 1", "up_to:1000", "number", 2, "times real time, 0 to 1000"),
    "flag": Type("bool {} = false", "truth", "boolean", True, "`true` or `false`"),
    "text": Type("std::string {}", "text", "string", "", "a text"),
    "person": Type("std::string {}", "person", "string", "Ada",
                   f"1 to {PERSON_LETTERS} {PERSON_RULE}"),
}


@dataclass
class Field:
    name: str
    type: Type
    example: object


@dataclass
class Command:
    name: str           # name of the struct
    word: str           # value of "do"
    may: str
    doc: str
    fields: list[Field]

    def example(self) -> str:
        return json.dumps({"do": self.word} | {f.name: f.example for f in self.fields if not f.type.optional})


def load_commands(path: Path) -> list[Command]:
    source = f"viewer/{path.name}"
    with path.open("rb") as file:
        table = tomllib.load(file)
    keys(source, table, {"command"}, set())
    commands = [_command(source, row) for row in table["command"]]
    unique(source, "name", [c.name for c in commands])
    unique(source, "do", [c.word for c in commands])
    return commands


def _command(source: str, row: dict) -> Command:
    where = f"{source}: {row.get('name', 'a command')}"
    keys(where, row, {"name", "may", "doc"}, {"do", "fields", "example"})
    typed(where, row, {"name": str, "may": str, "doc": str, "do": str, "fields": dict, "example": dict})
    one_of(where, "may", row["may"], RIGHTS)
    documented(where, row["doc"])
    if not re.fullmatch(r"([A-Z][a-z]+)+", row["name"]):
        raise SchemaError(f"{where}: name is that of a struct")
    fields, example = row.get("fields", {}), row.get("example", {})
    for name, kind in fields.items():
        one_of(f"{where}: {name}", "type", kind, TYPES)
    for name in example:
        one_of(where, "example of", name, fields)
    return Command(row["name"], row.get("do", row["name"].lower()), row["may"], row["doc"],
                   [Field(name, TYPES[kind], example.get(name, TYPES[kind].example)) for name, kind in fields.items()])
