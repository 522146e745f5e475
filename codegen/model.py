"""Loads and validates interfaces/*.toml.

Emitters read the values below and nothing else; every name they need is derived here, once, so that two languages
never disagree. A `SchemaError` names the file, the entry and what is wrong.
"""

from __future__ import annotations

import difflib
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from codegen.checks import SchemaError, documented, keys, unique

COMMON = "common"

# Scalar type -> bytes on the wire (everything is padded to a multiple of four).
SCALARS = {
    "char": 4, "int8": 4, "uint8": 4, "int16": 4, "uint16": 4, "int32": 4, "uint32": 4,
    "int64": 8, "float32": 4, "float64": 8,
}
FLOATS = {"float32", "float64"}
# Unsigned scalar -> the type of its value where a field is signed. Only one whose bytes are the same.
SIGNED = {"uint32": "int32"}
# Arrays of these travel as raw bytes padded to four, not element by element.
OPAQUE = {"char", "int8", "uint8"}

# Kind of message -> its number in the header.
KINDS = {"DATA": 1, "CMD": 2, "REQ": 3, "SYNCH": 5}
POLICIES = {"latest", "queue"}
UNIVERSAL = range(247, 256)  # request subtypes shared by all interfaces

# Largest body, and so the bound of an array whose `max` is "message".
BODY_BYTES = 33554392

# Frames by monogram: what (X pose, R orientation, p point, v velocity, a acceleration, n direction), then the
# frames it relates. docs/wire.md explains the letters.
FRAME = re.compile(r"[XRpvan]_[A-Z]{1,2}(_[A-Z])?$")
FRAME_LETTERS = set("WMORSTGIPBJE")
# Structs that place something in space: a field of such a type must say in which frame.
GEOMETRY = {"Pose2d", "Pose3d", "Point2d", "Point3d", "Orientation3d", "Segment", "Extent2d"}

# Structs that measure something: a field of such a type must say in which unit.
MEASURES = GEOMETRY | {"Bbox2d", "Bbox3d"}

# Every unit there is. A field's unit is one of them, or several with ", " between the parts of its value and " or "
# between what a part may be.
UNITS = (
    "1", "0.1", "%",                                    # plain numbers, tenths, hundredths
    "m", "mm", "m^2", "rad", "rad^2", "m rad", "1e-7 deg",
    "s", "ms", "us", "Hz", "MHz",
    "m/s", "rad/s", "m/s^2", "rad/s^2",
    "V", "A", "W", "J", "G", "lx", "degC",
    "px", "m/pixel", "bit", "byte", "bit/s",
)

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")
MESSAGE_NAME = re.compile(r"[A-Z][A-Z0-9_]*$")
STRUCT_NAME = re.compile(r"[A-Z][A-Za-z0-9]*$")
TYPE = re.compile(r"([A-Za-z_0-9]+\.)?([A-Za-z0-9]+)(\[(\d*)\])?$")


@dataclass
class Field:
    """One member of a struct. Exactly one of the shapes below holds.

    scalar or struct     length is None and max is None
    fixed array          length elements, no length on the wire
    counted array        at most max elements; a count word and a length word on the wire
    dynamic array        dynamic is True: as counted, bounded by the message only (max is that bound in elements)
    """

    name: str
    type: str                   # scalar name, or struct name; of the value, if it is signed
    owner: str                  # interface that defines the struct; "" for scalars, "common" for shared structs
    unit: str                   # "" only where there is no quantity
    frame: str
    doc: str
    length: int | None = None
    max: int | None = None
    dynamic: bool = False
    signed: bool = False        # unsigned in the original, but its value is signed (two's complement)
    count_before: str = ""      # field before which the count word is encoded; "": directly before the array
    line: int = 0               # of the definition's file; 0 if unknown

    @property
    def is_scalar(self) -> bool:
        return self.type in SCALARS

    @property
    def original_type(self) -> str:
        """The type of the original, which old programs know."""
        return next(unsigned for unsigned, value in SIGNED.items() if value == self.type) if self.signed else self.type

    @property
    def is_array(self) -> bool:
        return self.length is not None or self.max is not None

    @property
    def has_count(self) -> bool:
        return self.max is not None

    @property
    def is_text(self) -> bool:
        return self.is_array and self.type == "char"

    @property
    def is_bytes(self) -> bool:
        return self.is_array and self.type in ("uint8", "int8")

    @property
    def is_raw(self) -> bool:
        """An array of single bytes: text, image data and the like."""
        return self.is_array and self.type in OPAQUE

    @property
    def count_name(self) -> str:
        return self.name + "_count"

    def described(self, more: str = "") -> str:
        """What it means, with its unit and frame, and `more` if there is; empty if there is nothing to say."""
        unit = f"in {self.unit}" if self.unit and self.unit != "1" else ""
        sign = "signed" if self.signed else ""
        quantity = ", ".join(part for part in (unit, f"frame {self.frame}" if self.frame else "", sign, more) if part)
        text = self.doc.strip()
        if quantity:
            text = f"{text[:-1]} ({quantity})." if text else f"{quantity[0].upper()}{quantity[1:]}."
        return text


@dataclass
class Struct:
    """A payload or a part of one; fields are in wire order."""

    name: str          # PascalCase, unique in its interface
    c_name: str        # the C name that existing programs know
    doc: str
    fields: list[Field]
    min_bytes: int = 0  # on the wire, with every counted array empty

    def steps(self) -> list[tuple[str, Field]]:
        """The wire order as ("count", f) and ("value", f) steps; a counted array has both."""
        moved: dict[str, list[Field]] = {}
        for f in self.fields:
            if f.has_count and f.count_before:
                moved.setdefault(f.count_before, []).append(f)
        out: list[tuple[str, Field]] = []
        for f in self.fields:
            out += [("count", g) for g in moved.get(f.name, [])]
            if f.has_count and not f.count_before:
                out.append(("count", f))
            out.append(("value", f))
        return out


@dataclass
class Message:
    """One row of the catalogue. An ACK or NACK shares the row of its request."""

    kind: str           # DATA, CMD, REQ or SYNCH
    subtype: int
    name: str           # "GET_GEOM"
    payload: str        # struct name, "" for none
    owner: str          # interface that defines the payload
    policy: str         # "latest" or "queue" for DATA and CMD, else ""
    doc: str

    @property
    def label(self) -> str:
        return f"{self.kind.lower()}.{self.name.lower()}"

    @property
    def constant(self) -> str:
        """REQ_GET_GEOM"""
        return f"{self.kind}_{self.name}"


@dataclass
class Constants:
    """A group of named numbers, e.g. the values of one field."""

    doc: str
    c_prefix: str
    values: dict[str, int]


@dataclass
class Interface:
    name: str
    code: int | None            # None for the shared definitions
    doc: str
    source: str                 # "interfaces/004_position2d.toml"
    messages: list[Message] = field(default_factory=list)
    structs: list[Struct] = field(default_factory=list)
    constants: list[Constants] = field(default_factory=list)
    reserved: list[int] = field(default_factory=list)   # request subtypes that must not be reused
    value_rows: list[dict] = field(default_factory=list)    # [[value]] and [proxy], which codegen/proxies/ reads
    proxy_row: dict = field(default_factory=dict)

    def struct(self, name: str) -> Struct | None:
        return next((s for s in self.structs if s.name == name), None)

    def in_order(self) -> list[Struct]:
        """The structs, each after those that it contains."""
        done: list[Struct] = []

        def add(struct: Struct) -> None:
            if struct in done:
                return
            for f in struct.fields:
                if f.owner == self.name:
                    add(next(s for s in self.structs if s.name == f.type))
            done.append(struct)

        for struct in self.structs:
            add(struct)
        return done

    def sorted_messages(self) -> list[Message]:
        """In the order of the catalogue: by kind, then by subtype."""
        return sorted(self.messages, key=lambda m: (KINDS[m.kind], m.subtype))

    def full_name(self, message: Message) -> str:
        """position2d.req.get_geom, universal.req.capabilities"""
        return f"{self.name if self.code is not None else 'universal'}.{message.label}"

    def constant(self, name: str) -> str:
        """8BIT of audio becomes AUDIO_8BIT: names do not start with a digit."""
        return f"{self.name.upper()}_{name}" if name[0].isdigit() else name

    def needs(self) -> list[str]:
        """Other interfaces whose structs this one uses, "common" left out."""
        owners = {f.owner for s in self.structs for f in s.fields} | {m.owner for m in self.messages}
        return sorted(owners - {"", COMMON, self.name})


@dataclass
class Schema:
    common: Interface
    interfaces: list[Interface]     # by code

    def all(self) -> list[Interface]:
        return [self.common, *self.interfaces]

    def restricted(self, names: set[str]) -> Schema:
        """With these interfaces alone."""
        return Schema(self.common, [i for i in self.interfaces if i.name in names])

    def interface(self, name: str) -> Interface:
        return next(i for i in self.all() if i.name == name)

    def struct_of(self, f: Field) -> Struct:
        found = self.interface(f.owner).struct(f.type)
        assert found is not None
        return found


class Row(dict):
    """A table of a file, with its line."""

    line = 0


def load(folder: Path) -> Schema:
    """Every file of the folder, checked. Raises SchemaError."""
    parsed = []
    for path in sorted(folder.glob("*.toml")):
        try:
            text = path.read_text(encoding="utf-8")
            parsed.append((f"interfaces/{path.name}", _with_lines(tomllib.loads(text), text)))
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
            raise SchemaError(f"interfaces/{path.name}: {error}") from error
    return build(parsed)


def _with_lines(table: dict, text: str) -> dict:
    """The fields of all structs as rows with their lines, which the parser does not provide."""
    lines, inside = [], False
    for number, line in enumerate(text.splitlines(), 1):
        bare = re.sub(r'"(\\.|[^"\\])*"', "", line).partition("#")[0]
        if bare.startswith("["):
            inside = bare.strip() == "[[struct]]"
        lines += [number] * (bare.count("{") if inside else 0)
    structs = table.get("struct", [])
    if len(lines) != sum(len(struct.get("fields", [])) for struct in structs):
        return table  # other layout: errors are reported without a line
    for struct in structs:
        struct["fields"] = [Row(entry) for entry in struct.get("fields", [])]
        for row in struct["fields"]:
            row.line = lines.pop(0)
    return table


def build(parsed: list[tuple[str, dict]]) -> Schema:
    """The same from parsed files: (source, table) pairs."""
    interfaces = [_interface(source, table) for source, table in parsed]
    shared = [i for i in interfaces if i.code is None]
    if len(shared) != 1 or shared[0].name != COMMON:
        raise SchemaError(f'interfaces/: exactly one file without a code is expected, named "{COMMON}"')
    numbered = sorted((i for i in interfaces if i.code is not None), key=lambda i: i.code)
    unique("interfaces/", "interface name", [i.name for i in interfaces])
    unique("interfaces/", "interface code", [i.code for i in numbered])
    schema = Schema(shared[0], numbered)
    unique("interfaces/", "c_name", [s.c_name for i in interfaces for s in i.structs])
    for interface in schema.all():
        _resolve(schema, interface)
    for interface in schema.all():
        for struct in interface.structs:
            struct.min_bytes = _min_bytes(schema, struct, ())
    for interface in schema.all():
        _bound_arrays(schema, interface)
        _match_units(schema, interface)
    return schema


def _interface(source: str, table: dict) -> Interface:
    keys(source, table, {"name", "doc"}, {"code", "reserved", "message", "struct", "constants", "value", "proxy"})
    name, code = table["name"], table.get("code")
    if not NAME.match(name) or name != name.lower():
        raise SchemaError(f'{source}: "{name}" is not a name in lower case')
    if code is not None and (not isinstance(code, int) or not 0 < code < 65536):
        raise SchemaError(f"{source}: code {code} is not in 1..65535")
    documented(source, table["doc"])
    interface = Interface(name, code, table["doc"], source)
    interface.reserved = list(table.get("reserved", []))
    interface.value_rows, interface.proxy_row = table.get("value", []), table.get("proxy", {})
    interface.messages = [_message(source, code, row) for row in table.get("message", [])]
    interface.structs = [_struct(source, row) for row in table.get("struct", [])]
    interface.constants = [_constants(source, name, row) for row in table.get("constants", [])]
    unique(source, "struct", [s.name for s in interface.structs])
    unique(source, "message", [m.label for m in interface.messages])
    unique(source, "message number", [f"{m.kind} {m.subtype}" for m in interface.messages])
    unique(source, "constant", [n for c in interface.constants for n in c.values])
    for message in interface.messages:
        if message.kind == "REQ" and message.subtype in interface.reserved:
            raise SchemaError(f"{source}: {message.label} uses the reserved subtype {message.subtype}")
    return interface


def _message(source: str, code: int | None, row: dict) -> Message:
    where = f"{source}: message {row.get('name', '?')}"
    keys(where, row, {"kind", "subtype", "name", "doc"}, {"payload", "policy"})
    kind, subtype = row["kind"], row["subtype"]
    if kind not in KINDS:
        raise SchemaError(f"{where}: invalid kind {kind!r}: {', '.join(KINDS)} are valid")
    if not MESSAGE_NAME.match(row["name"]):
        raise SchemaError(f"{where}: not a name in upper case")
    if not isinstance(subtype, int) or not 0 < subtype < 256:
        raise SchemaError(f"{where}: subtype {subtype} is not in 1..255")
    if kind == "REQ" and (subtype in UNIVERSAL) != (code is None):
        raise SchemaError(f"{where}: subtype {subtype}: 247..255 belong to the shared requests, and only they do")
    policy = row.get("policy", "")
    if (kind in ("DATA", "CMD")) != (policy in POLICIES):
        raise SchemaError(f'{where}: DATA and CMD (and only they) need policy "latest" or "queue"')
    documented(where, row["doc"])
    return Message(kind, subtype, row["name"], row.get("payload", ""), "", policy, row["doc"])


def _struct(source: str, row: dict) -> Struct:
    name = row.get("name", "?")
    where = f"{source}: struct {name}"
    keys(where, row, {"name", "c_name", "doc", "fields"}, set())
    if not STRUCT_NAME.match(row["name"]):
        raise SchemaError(f"{where}: not a name in PascalCase")
    documented(where, row["doc"])
    fields = [_field(source, name, entry) for entry in row["fields"]]
    if not fields:
        raise SchemaError(f"{where}: has no fields")
    names = [f.name for f in fields]
    unique(where, "field", names + [f.count_name for f in fields if f.has_count])
    for f in fields:
        if f.count_before and (f.count_before not in names or names.index(f.count_before) >= names.index(f.name)):
            raise SchemaError(f"{where}: {f.name}: count_before names no earlier field")
    return Struct(row["name"], row["c_name"], row["doc"], fields)


def _place(source: str, struct: str, field_name: str, line: int) -> str:
    return f"{source}{f':{line}' if line else ''}: struct {struct}: field {field_name}"


def _field(source: str, struct: str, row: dict) -> Field:
    line = row.line if isinstance(row, Row) else 0
    where = _place(source, struct, row.get("name", "?"), line)
    keys(where, row, {"name", "type"}, {"unit", "frame", "doc", "max", "count_before", "signed"})
    if not NAME.match(row["name"]):
        raise SchemaError(f"{where}: not a name")
    shape = TYPE.match(row["type"])
    if not shape:
        raise SchemaError(f"{where}: unknown type {row['type']!r}")
    owner, base, brackets, length = shape.groups()
    f = Field(row["name"], base, (owner or "").rstrip("."), row.get("unit", ""), row.get("frame", ""),
              row.get("doc", ""), signed="signed" in row, count_before=row.get("count_before", ""), line=line)
    _shape(where, f, brackets, length, row.get("max"))
    if row.get("signed", True) is not True:
        raise SchemaError(f"{where}: signed = {row['signed']!r}, valid: true")
    if f.signed and (f.is_array or f.type not in SIGNED):
        raise SchemaError(f"{where}: signed is for single numbers of type uint32")
    if f.signed:
        f.type = SIGNED[f.type]
    if f.type in FLOATS and not f.unit:
        raise SchemaError(f'{where}: a float needs a unit ("1" for a plain number)')
    if f.type in GEOMETRY and not f.frame:
        raise SchemaError(f"{where}: a {f.type} needs a frame")
    if f.frame and not (FRAME.match(f.frame) and set(f.frame[2:]) - {"_"} <= FRAME_LETTERS):
        raise SchemaError(f"{where}: frame {f.frame!r} is not a monogram such as X_OR")
    if f.type in MEASURES and not f.unit:
        raise SchemaError(f"{where}: a {f.type} needs a unit")
    _known_units(where, f.unit)
    return f


def _known_units(where: str, unit: str) -> None:
    for part in unit.split(",") if unit else []:
        for one in part.strip().split(" or "):
            if one not in UNITS:
                raise SchemaError(f"{where}: unknown unit {one!r} (did you mean {_nearest_unit(one)!r}? "
                                  "codegen/model.py lists them all)")


def _nearest_unit(text: str) -> str:
    """The most likely unit; most units abbreviate a word with the same beginning."""
    text = text.lower()

    def likeness(unit: str) -> float:
        unit = unit.lower()
        return difflib.SequenceMatcher(None, text, unit).ratio() + text.startswith(unit) + text.startswith(unit[0])

    return max(UNITS, key=likeness)


def _shape(where: str, f: Field, brackets: str | None, length: str | None, bound) -> None:
    if not brackets:
        if bound is not None or f.count_before:
            raise SchemaError(f"{where}: max and count_before are for arrays")
    elif length:
        if bound is not None or f.count_before:
            raise SchemaError(f"{where}: an array of fixed length has no max and no count")
        f.length = int(length)
        if f.length == 0:
            raise SchemaError(f"{where}: an array of length 0")
    elif bound == "message":
        f.dynamic, f.max = True, BODY_BYTES
    elif isinstance(bound, int) and bound > 0:
        f.max = bound
    else:
        raise SchemaError(f'{where}: unbounded array: give max, a number or "message"')


def _constants(source: str, name: str, row: dict) -> Constants:
    where = f"{source}: constants"
    keys(where, row, {"doc", "values"}, {"c_prefix"})
    documented(where, row["doc"])
    for key, value in row["values"].items():
        if not re.match(r"[A-Za-z0-9_]+$", key) or not isinstance(value, int):
            raise SchemaError(f"{where}: {key} = {value!r} is not a named whole number")
    return Constants(row["doc"], row.get("c_prefix", f"PLAYER_{name.upper()}_"), dict(row["values"]))


def _resolve(schema: Schema, interface: Interface) -> None:
    """Sets the owning interface of each referenced struct."""
    for struct in interface.structs:
        for f in struct.fields:
            if f.is_scalar:
                if f.owner:
                    raise SchemaError(f"{interface.source}: {struct.name}.{f.name}: unknown type")
                continue
            where = _place(interface.source, struct.name, f.name, f.line)
            f.owner, f.type = _find(schema, interface, where, f.owner, f.type)
    for m in interface.messages:
        if m.payload:
            owner, _, name = m.payload.rpartition(".")
            where = f"{interface.source}: message {m.label}"
            m.owner, m.payload = _find(schema, interface, where, owner, name)


def _find(schema: Schema, interface: Interface, where: str, owner: str, name: str) -> tuple[str, str]:
    candidates = [i for i in schema.all() if i.name == owner] if owner else [interface, schema.common]
    for candidate in candidates:
        if candidate.struct(name):
            return candidate.name, name
    raise SchemaError(f"{where}: unknown type {(owner + '.' if owner else '') + name!r}")


def _min_bytes(schema: Schema, struct: Struct, above: tuple[str, ...]) -> int:
    if struct.c_name in above:
        raise SchemaError(f"struct {struct.name} contains itself")
    return sum(_field_bytes(schema, f, (*above, struct.c_name)) for f in struct.fields)


def _field_bytes(schema: Schema, f: Field, above: tuple[str, ...]) -> int:
    if f.has_count:
        if not f.is_scalar:
            _min_bytes(schema, schema.struct_of(f), above)  # detects recursive structs
        return 8
    one = SCALARS[f.type] if f.is_scalar else _min_bytes(schema, schema.struct_of(f), above)
    if f.length is None:
        return one
    return (f.length + 3) // 4 * 4 if f.type in OPAQUE else one * f.length


def _bound_arrays(schema: Schema, interface: Interface) -> None:
    """An array bounded by the message holds at most as many elements as fit a body."""
    for struct in interface.structs:
        for f in struct.fields:
            if f.dynamic:
                one = 1 if f.type in OPAQUE else SCALARS.get(f.type) or schema.struct_of(f).min_bytes
                f.max = BODY_BYTES // one


def _match_units(schema: Schema, interface: Interface) -> None:
    """One unit for the whole value, or one for each of its parts."""
    for struct in interface.structs:
        for f in struct.fields:
            units, parts = len(f.unit.split(",")), parts_of(schema, f)
            if units not in (1, parts):
                where = _place(interface.source, struct.name, f.name, f.line)
                raise SchemaError(f"{where}: {units} units for a value of {parts} part{'' if parts == 1 else 's'}")


def parts_of(schema: Schema, f: Field) -> int:
    """Numbers in one value of the field. The elements of a list without a fixed length are alike and count once."""
    one = 1 if f.is_scalar else sum(parts_of(schema, inner) for inner in schema.struct_of(f).fields)
    return one * (f.length or 1)
