"""State of a kind in the world, and its fields for viewers: `[[record]]`, `[[column]]` and `[[viewer]]`."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from codegen.checks import SchemaError, documented, keys, one_of, typed, unique
from codegen.kind_words import Word, known_unit
from codegen.model import FRAME, FRAME_LETTERS

# Type of a column -> (how many numbers a unit may be told for, the names of its parts).
TYPES = {
    "flag": (0, ()), "uint8": (1, ()), "int32": (1, ()), "uint32": (1, ()), "uint64": (1, ()), "float32": (1, ()), "float64": (1, ()),
    "text": (0, ()), "row": (0, ()), "color": (0, ()), "size": (3, ("x", "y", "z")),
    "vector3": (3, ("x", "y", "z")), "pose": (4, ("x", "y", "z", "a")), "twist": (4, ("x", "y", "z", "a")), "tilt": (2, ("x", "y")), "velocity6": (6, ("v.x", "v.y", "v.z", "w.x", "w.y", "w.z")),
    "ModelKind": (0, ()), "ControlMode": (0, ()), "ModelId": (0, ()), "Mobility": (0, ()),
}
# Type of a column -> types of the words that may say what it begins with.
WORDED = {"flag": ("flag",), "float64": ("number", "length", "angle")}
# A number of these has a unit, "1" where there is none.
MEASURED = {"float32", "float64", "size", "vector3", "pose", "twist", "tilt", "velocity6"}

# What a column is to a run (playhouse/world/columns.h).
ROLES = ("population", "motion", "mark", "setting", "sensed", "shown", "use", "derived")
UNCHANGED = {"population", "derived"}  # written only when the population changes
# Phases of the tick, and the ways to change the world between ticks.
WRITERS = ("decide", "act", "move", "sense", "energy", "commands", "devices", "place", "attach", "detach", "set_odometry",
           "set_fiducial_return", "set_color", "set_say", "draw", "clear_drawing", "add_flags", "subscribe", "unsubscribe", "subscribe_controller",
           "watch", "unwatch")
# When a viewer gets a field: once with the scene; whenever it differs; that while its robot is selected; that while its
# robot is selected, or in view of a page that shows sensors.
TIMES = ("start", "changed", "selected", "shown")
# How a field travels: as JSON; as a zigzag varint of the difference; as 16 bits of a turn; as one of the bits of the
# model's state; as a text of UTF-8; and as what the names say.
CODES = ("json", "difference", "turn", "bit", "rgba", "fraction", "varint", "zigzag", "text")
# What 1 stands for in the whole numbers that travel: one of these, or a thousandth of a unit, as mm/s.
QUANTA = ("J", "1/1000", "px", "1/65536 turn", "1/65535 of range_max")
QUANTIZED = {"difference", "turn", "fraction"}

RECORD = re.compile(r"[A-Z][A-Za-z0-9]*$")
NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")
KEY_TYPES = {key: str for key in ("name", "doc", "type", "unit", "quantum", "frame", "role", "writer", "per", "field", "from", "code",
                                  "when", "word")} | {"list": bool, "fields": list}


@dataclass
class Quantity:
    """A column, or a field of a record."""

    name: str
    type: str
    unit: str
    frame: str
    doc: str
    role: str = ""      # of columns
    writer: str = ""
    per: str = ""       # "beam": a row of the column is a beam, not a row of the table
    list: bool = False  # a row holds any number of values
    word: str = ""      # word for the initial value, also used to save the current one


@dataclass
class Record:
    name: str
    doc: str
    fields: list[Quantity]


@dataclass
class Shown:
    """A field for viewers."""

    field: str
    source: str     # a column or word, or a part of it: "X_PM.x"
    unit: str       # of numbers in JSON
    quantum: str    # of integers
    code: str
    when: str


@dataclass
class State:
    records: list[Record] = field(default_factory=list)
    columns: list[Quantity] = field(default_factory=list)
    viewer: list[Shown] = field(default_factory=list)


def state(where: str, table: dict, words: list[Word]) -> State:
    """`words` are those that may be sent to a viewer at the start."""
    out = State()
    for row in table.get("record", []):
        out.records.append(_record(f"{where}: record {row.get('name', '?')}", row))
    for row in table.get("column", []):
        out.columns.append(_column(f"{where}: column {row.get('name', '?')}", row, out.records, words))
    for row in table.get("viewer", []):
        out.viewer.append(_shown(f"{where}: viewer {row.get('field', '?')}", row, out, words))
    unique(where, "record", [r.name for r in out.records])
    unique(where, "column", [c.name for c in out.columns])
    unique(where, "viewer field", [f"{s.field} ({'start' if s.when == 'start' else 'running'})" for s in out.viewer])
    return out


def _record(where: str, row: dict) -> Record:
    keys(where, row, {"name", "doc", "fields"}, set())
    typed(where, row, KEY_TYPES)
    if not RECORD.match(row["name"]):
        raise SchemaError(f"{where}: not a name in PascalCase")
    documented(where, row["doc"])
    fields = []
    for entry in row["fields"]:
        inner = f"{where}: field {entry.get('name', '?')}"
        keys(inner, entry, {"name", "type", "doc"}, {"unit", "frame"})
        typed(inner, entry, KEY_TYPES)
        fields.append(_quantity(inner, entry, []))
    unique(where, "field", [f.name for f in fields])
    return Record(row["name"], row["doc"], fields)


def _column(where: str, row: dict, records: list[Record], words: list[Word]) -> Quantity:
    keys(where, row, {"name", "type", "role", "doc"}, {"unit", "frame", "writer", "per", "list", "word"})
    typed(where, row, KEY_TYPES)
    out = _quantity(where, row, [r.name for r in records])
    one_of(where, "role", row["role"], ROLES)
    out.role, out.writer, out.per, out.list = row["role"], row.get("writer", ""), row.get("per", ""), row.get("list", False)
    for writer in out.writer.split(", ") if out.writer else []:
        one_of(where, "writer", writer, WRITERS)
    if out.role not in UNCHANGED and not out.writer:
        raise SchemaError(f"{where}: writer is missing: only what stays as it came has none")
    if out.per:
        one_of(where, "per", out.per, ["beam"])
    if "word" in row:
        fitting = [w.name for w in words if w.type in WORDED.get(out.type, ()) and w.has_member and not (w.optional or w.indexed)]
        one_of(where, f"word of a {out.type}", row["word"], fitting)
        out.word = row["word"]
    return out


def _quantity(where: str, row: dict, records: list[str]) -> Quantity:
    if not NAME.match(row["name"]):
        raise SchemaError(f"{where}: not a name")
    one_of(where, "type", row["type"], [*TYPES, *records])
    documented(where, row["doc"])
    unit, frame = row.get("unit", ""), row.get("frame", "")
    if row["type"] in MEASURED and not unit:
        raise SchemaError(f'{where}: a {row["type"]} needs a unit ("1" for a plain number)')
    for units in unit.split(" or ") if unit else []:
        parts, numbers = units.count(",") + 1, TYPES.get(row["type"], (0, ()))[0]
        if parts not in (1, numbers) or numbers == 0:
            raise SchemaError(f"{where}: {parts} unit{'' if parts == 1 else 's'} for a value of {numbers}")
    if row["type"] == "pose" and not frame:
        raise SchemaError(f"{where}: a pose needs a frame")
    if frame and not (FRAME.match(frame) and set(frame[2:]) - {"_"} <= FRAME_LETTERS):
        raise SchemaError(f"{where}: frame {frame!r} is not a monogram such as X_OR")
    return Quantity(row["name"], row["type"], unit, frame, row["doc"])


def milli(quantum: str) -> str:
    """The unit of a quantum that is a thousandth of it, else "": "m/s or rad/s" of "mm/s or mrad/s"."""
    parts = quantum.split(" or ")
    return " or ".join(part[1:] for part in parts) if all(part[:1] == "m" and part[1:] for part in parts) else ""


def _shown(where: str, row: dict, known: State, words: list[Word]) -> Shown:
    keys(where, row, {"field", "from", "code", "when"}, {"unit", "quantum"})
    typed(where, row, KEY_TYPES)
    one_of(where, "code", row["code"], CODES)
    one_of(where, "when", row["when"], TIMES)
    if (row["code"] == "json") != (row["when"] == "start"):
        raise SchemaError(f"{where}: what is told at the start, and only that, travels as json")
    if "unit" in row and row["code"] != "json":
        raise SchemaError(f"{where}: unit is for json; what travels as a whole number has a quantum")
    if "quantum" in row or row["code"] in QUANTIZED:
        quantum = row.get("quantum")
        if quantum in QUANTA or not milli(quantum or ""):
            one_of(where, "quantum", quantum, QUANTA)
        else:
            known_unit(where, "quantum", milli(quantum))
    name, _, part = row["from"].partition(".")
    columns = {c.name: c for c in known.columns}
    from_start = {w.name for w in words} if row["when"] == "start" else set()
    one_of(where, "from", name, [*columns, *sorted(from_start)])
    if part:
        record = next((r for r in known.records if name in columns and r.name == columns[name].type), None)
        parts = [f.name for f in record.fields] if record else TYPES[columns[name].type][1] if name in columns else ()
        one_of(where, f"part of {name}", part, parts)
    return Shown(row["field"], row["from"], row.get("unit", ""), row.get("quantum", ""), row["code"], row["when"])
