"""Loads and validates kinds/*.toml.

A kind is a type of scene entity: a model type, a part of one, a trait that models of any type may have, the window, or the
world file itself. Emitters read only the values below. A `SchemaError` names the file, the line and entry, the key, and the fault.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from codegen.changes import Change, changes
from codegen.checks import SchemaError, documented, keys, one_of, typed, unique
from codegen.kind_old import OldType, OldWord, check_old, old_type, old_word
from codegen.kind_state import State, state
from codegen.kind_words import WORD, Word, check_together, word
from codegen.model import Schema

# Place of an entity in a file.
ENTITIES = {
    "model": "at the top level, or inside another model",
    "part": "inside a model of the type `inside`, or of any type if that is \"model\"",
    "trait": "none: words of a model of any type define it",
    "window": "at the top level",
    "world": "the file itself",
}
BASE = "model"  # the type whose words every model has

# Numbering of the devices of an interface in the automatic map.
INDICES = {
    "one": "0, the only one",
    "robot": "the robot's index; further ones, and those without a robot, are numbered after all robots",
    "count": "numbered over all robots",
}
# What a model must have for an interface.
NEEDS = {
    "": "nothing",
    "scanner": "a sensor with several samples",
    "several sensors": "several sensors",
    "robot": "a top-level model with a drive",
    "rings": "a sensor with several rings",
    "contacts or lamps": "a bumper or a lamp, itself or as a part of it",
    "baseline": "a second lens, by `baseline`",
    "never": "a section of a configuration file that names it",
}

KEY_TYPES = {key: str for key in ("name", "entity", "doc", "kind", "inside", "table", "not_in_stage", "index", "when", "listed_when", "form", "from")}
KEY_TYPES |= {"number": int, "watts": (int, float), "volts": (int, float), "body": dict, "old": dict, "old_types": dict, "silent_why": dict, "size": list, "color": list, "solid": bool, "shared": bool, "watchable": bool}
KEY_TYPES |= {key: list for key in ("given_by", "silent", "word", "interface", "voltages", "record", "column", "viewer", "change")}


@dataclass
class Body:
    size: list[float]       # m
    color: list[float]      # red, green, blue, alpha from 0 to 1
    solid: bool             # it has a body, unless blocks or a bitmap say otherwise
    form: str               # what that is, if it is one of its own (playhouse/scene/forms/body_NAME.cc); "" a box


@dataclass
class Voltage:
    """A voltage of an analog sensor: so many volts per unit of a column."""

    column: str
    volts: float


@dataclass
class Served:
    """An interface of Player through which models of the kind are seen; those of BASE are of every kind."""

    name: str
    code: int
    index: str
    when: str               # what the model must have; "" nothing
    listed_when: str        # the same, for the automatic map alone
    shared: bool            # several devices of a configuration file may be of one model
    voltages: list[Voltage] = field(default_factory=list)  # of aio, from columns; without any, a NAME.cc below playhouse/bridge/interfaces/ has the device


@dataclass
class Kind:
    name: str
    entity: str
    doc: str
    source: str             # "kinds/position.toml"
    kind: str               # the enumerator's name, in lower case; "plain" for models
    number: int | None      # of ModelKind; None for what is not simulated, and for what is no model
    inside: str             # of parts: the type they belong into
    table: str              # of the world's state, "" for none
    watts: float | None     # that it draws while it is subscribed; of parts each; None: what the word `watts` says
    given_by: list[str]     # of traits: the words that give a model one
    watchable: bool         # what acts and measures: it acts for others than watchers alone
    body: Body | None
    words: list[Word] = field(default_factory=list)
    silent: list[str] = field(default_factory=list)
    silent_why: dict[str, str] = field(default_factory=dict)  # why words have no effect; that of "" is for those that are not there
    old: list[OldWord] = field(default_factory=list)
    old_types: list[OldType] = field(default_factory=list)
    interfaces: list[Served] = field(default_factory=list)
    state: State = field(default_factory=State)
    changes: list[Change] = field(default_factory=list)

    @property
    def simulated(self) -> bool:
        return self.entity != "model" or self.number is not None

    @property
    def measures(self) -> bool:
        """It measures, when it is due."""
        return any(c.name == "measured_tick" for c in self.state.columns)

    @property
    def may_be_watched(self) -> bool:
        """It measures for those who only look, and then does nothing else."""
        return self.measures and (self.watchable or not self.acts)

    @property
    def acts(self) -> bool:
        """It does something with its commands in the phase `act`."""
        return self._writes("act")

    @property
    def moves(self) -> bool:
        """It moves by itself in the phase `move`, and takes along what it carries."""
        return self.name != BASE and self._writes("move")

    def _writes(self, phase: str) -> bool:
        return any(phase in c.writer.split(", ") for c in self.state.columns)

    @property
    def members(self) -> list[Word]:
        """Words that the description has a member for."""
        return [w for w in self.words if w.has_member] if self.simulated else []

    @property
    def desc(self) -> str:
        """The name of the description."""
        owner = self.inside if self.entity == "part" and self.inside != BASE else ""
        return f"{owner.title()}{(self.kind or self.name).title()}Desc"


@dataclass
class Kinds:
    all: list[Kind]     # models that are simulated by number, other models, then the rest, each by name

    def models(self) -> list[Kind]:
        return [k for k in self.all if k.entity == "model"]

    def simulated(self) -> list[Kind]:
        return [k for k in self.models() if k.number is not None]

    def find(self, name: str) -> Kind:
        return next(k for k in self.all if k.name == name)

    def traits(self) -> list[Kind]:
        return [k for k in self.all if k.entity == "trait"]

    def parts_of(self, kind: Kind) -> list[Kind]:
        return [k for k in self.all if k.entity == "part" and k.inside == kind.name]


def load_kinds(folder: Path, schema: Schema) -> Kinds:
    """Every file of the folder, checked. Raises SchemaError."""
    parsed = []
    for path in sorted(folder.glob("*.toml")):
        source = f"kinds/{path.name}"
        try:
            text = path.read_text(encoding="utf-8")
            parsed.append((source, _with_lines(tomllib.loads(text), text)))
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
            raise SchemaError(f"{source}: {error}") from error
    return build_kinds(parsed, schema)


def _with_lines(table: dict, text: str) -> dict:
    """The words with the lines of their headers; the parser does not tell them."""
    lines = [n for n, line in enumerate(text.splitlines(), 1) if re.match(r"\[\[word\]\]", line)]
    for row, line in zip(table.get("word", []), lines):
        row["line"] = line
    return table


def build_kinds(parsed: list[tuple[str, dict]], schema: Schema) -> Kinds:
    """The same from parsed files: (source, table) pairs."""
    for source, table in parsed:
        _check_head(source, table)
    base = next((table for _, table in parsed if table["name"] == BASE), None)
    if base is None or base["entity"] != "model" or base.get("number") != 0:
        raise SchemaError(f'kinds/: a model named "{BASE}" with number 0 is expected, whose words all models have')
    kinds = [_kind(source, table, schema) for source, table in parsed]
    kinds.sort(key=lambda k: (list(ENTITIES).index(k.entity), k.number is None, k.number, k.name))
    out = Kinds(kinds)
    unique("kinds/", "name", [k.name for k in kinds])
    unique("kinds/", "number", [k.number for k in out.simulated()])
    if [k.number for k in out.simulated()] != list(range(len(out.simulated()))):
        raise SchemaError("kinds/: the numbers of models count from 0 without a gap")
    for entity in ("window", "world"):
        if sum(k.entity == entity for k in kinds) != 1:
            raise SchemaError(f"kinds/: exactly one {entity} is expected")
    unique("kinds/", "change", [c.name for k in kinds for c in k.changes])
    unique("kinds/", "old type", [t.name for k in kinds for t in k.old_types])
    unique("kinds/", "table", [k.table for k in kinds if k.table])
    unique("kinds/", "enum", [w.enum for k in kinds for word in k.words for w in [word, *word.choices] if w.enum])
    for kind in kinds:
        _check_neighbours(out, kind)
    for source, table in parsed:
        kind = out.find(table["name"])
        kind.state = state(source, table, kind.words + (out.find(BASE).words if kind.entity in ("model", "trait") else []))
        if kind.state.columns and not kind.table:
            raise SchemaError(f"{source}: columns need a table")
        _check_voltages(kind)
    return out


def _check_head(source: str, table: dict) -> None:
    keys(source, table, {"name", "entity", "doc"}, {
        "kind", "number", "inside", "table", "watts", "given_by", "watchable", "not_in_stage", "body", "silent", "silent_why", "old", "old_types", "word",
        "interface", "record", "column", "viewer", "change"})
    typed(source, table, KEY_TYPES)
    if not WORD.match(table["name"]):
        raise SchemaError(f"{source}: name {table['name']!r} is not a word in lower case")
    one_of(source, "entity", table["entity"], ENTITIES)
    documented(source, table["doc"])
    if source.rpartition("/")[2] != f"{table['name']}.toml":
        raise SchemaError(f"{source}: the file of {table['name']!r} is kinds/{table['name']}.toml")


def _kind(source: str, table: dict, schema: Schema) -> Kind:
    entity, number = table["entity"], table.get("number")
    if number is not None and entity != "model":
        raise SchemaError(f"{source}: number is for a model, not for a {entity}")
    for key, wanted in (("inside", "part"), ("body", "model"), ("given_by", "trait")):
        if (key in table) != (entity == wanted):
            raise SchemaError(f"{source}: a {wanted}, and only a {wanted}, has {key}")
    out = Kind(table["name"], entity, table["doc"], source, table.get("kind", table["name"] if number is not None else ""),
               number, table.get("inside", ""), table.get("table", ""), table.get("watts"), table.get("given_by", []), table.get("watchable", False),
               _body(f"{source}: body", table.get("body")))
    if "kind" in table and number is None:
        raise SchemaError(f"{source}: kind names a number of ModelKind, and there is none")
    if out.number is not None and not out.table:
        raise SchemaError(f"{source}: table is missing: a model that is simulated has one")
    if out.watts is not None and (out.entity not in ("model", "part") or out.watts < 0):
        raise SchemaError(f"{source}: watts are what a model or a part of it draws, at least 0")
    if out.entity == "trait" and not out.table:
        raise SchemaError(f"{source}: table is missing: of a trait the world keeps something")
    for row in table.get("word", []):
        line = row.pop("line", 0)
        where = f"{source}{f':{line}' if line else ''}: word {row.get('name', '?')}"
        if "not_in_stage" in table:  # nor are its words: why
            row = {"stage": "none", "stage_why": table["not_in_stage"], **row}
        out.words.append(word(where, row, out.simulated))
    out.silent, out.silent_why = table.get("silent", []), table.get("silent_why", {})
    out.old = [old_word(f"{source}: old {name}", name, entry) for name, entry in table.get("old", {}).items()]
    out.old_types = [old_type(f"{source}: old_types {name}", name, entry) for name, entry in table.get("old_types", {}).items()]
    unique(source, "word", [w.name for w in out.words] + out.silent + [w.name for w in out.old])
    _check_silent_why(source, out)
    check_together(lambda w: f"{source}: word {w.name}", out.words)
    out.interfaces = [_served(f"{source}: interface {row.get('name', '?')}", row, schema)
                      for row in table.get("interface", [])]
    unique(source, "interface", [s.name for s in out.interfaces])
    out.changes = changes(source, table.get("change", []))
    if out.changes and entity not in ("world", "trait") and number is None:
        raise SchemaError(f"{source}: a change is of a model that is simulated, of a trait or of the world")
    return out


def _check_silent_why(source: str, kind: Kind) -> None:
    for name, why in kind.silent_why.items():
        if name:
            one_of(f"{source}: silent_why", "word", name, kind.silent)
        documented(f"{source}: silent_why {name}", why)
    untold = [name for name in kind.silent if name not in kind.silent_why and "" not in kind.silent_why]
    if untold:
        raise SchemaError(f"{source}: silent_why: nothing is said of {untold[0]}")


def _body(where: str, row: dict | None) -> Body | None:
    if row is None:
        return None
    keys(where, row, {"size", "color", "solid"}, {"form"})
    typed(where, row, KEY_TYPES)
    if "form" in row and not row["solid"]:
        raise SchemaError(f"{where}: form is for what is solid")
    for key, length in (("size", 3), ("color", 4)):
        if len(row[key]) != length or any(type(v) not in (int, float) or v < 0 for v in row[key]):
            raise SchemaError(f"{where}: {key} is {length} numbers that are not negative")
    return Body(row["size"], row["color"], row["solid"], row.get("form", ""))


def _served(where: str, row: dict, schema: Schema) -> Served:
    keys(where, row, {"name", "index"}, {"when", "listed_when", "shared", "voltages"})
    typed(where, row, KEY_TYPES)
    one_of(where, "name", row["name"], [i.name for i in schema.interfaces])
    one_of(where, "index", row["index"], INDICES)
    for key in ("when", "listed_when"):
        if key in row:
            one_of(where, key, row[key], NEEDS)
    code = schema.interface(row["name"]).code
    assert code is not None
    return Served(row["name"], code, row["index"], row.get("when", ""), row.get("listed_when", ""), row.get("shared", False),
                  [_voltage(where, entry) for entry in row.get("voltages", [])])


def _voltage(where: str, entry: dict) -> Voltage:
    keys(f"{where}: voltages", entry, {"from", "volts"}, set())
    typed(f"{where}: voltages", entry, KEY_TYPES)
    return Voltage(entry["from"], entry["volts"])


def _check_voltages(kind: Kind) -> None:
    for served in (s for s in kind.interfaces if s.voltages):
        where = f"{kind.source}: interface {served.name}: voltages"
        if served.name != "aio" or not kind.measures:
            raise SchemaError(f"{where}: they are for the aio of a sensor")
        for voltage in served.voltages:
            one_of(where, "from", voltage.column, [c.name for c in kind.state.columns if c.type == "float64" and not (c.list or c.per)])


def _check_neighbours(kinds: Kinds, kind: Kind) -> None:
    """What one kind says of another."""
    models = {k.name: k for k in kinds.models()}
    if kind.entity == "part":
        one_of(kind.source, "inside", kind.inside, models)
    if kind.entity == "model" and kind.name != BASE:
        base = kinds.find(BASE)
        taken = {w.name for w in base.words} | set(base.silent) | {w.name for w in base.old}
        for name in [w.name for w in kind.words] + kind.silent:
            if name in taken:
                raise SchemaError(f"{kind.source}: word {name}: every model has that word (kinds/{BASE}.toml)")
    optional = [w.name for w in kinds.find(BASE).words if w.has_member and w.optional]
    for name in kind.given_by:
        one_of(f"{kind.source}: given_by", "word", name, optional)
    for old in kind.old_types:
        if old.name in models:
            raise SchemaError(f"{kind.source}: old_types: {old.name} is a type, see {models[old.name].source}")
    check_old(kinds, kind)
