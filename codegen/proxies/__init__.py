"""The proxies of the client libraries: [proxy] and [[value]] of interfaces/*.toml, checked against the messages they use.

A proxy is the class of one interface in a client library. Emitters of all languages read the values below and nothing
else. What a value's number means on the wire is never said again: its type and its factor follow from the field of the
message and its unit. docs/adr/0029 tells how to write one.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from codegen.checks import SchemaError, documented, keys, one_of, unique
from codegen.model import COMMON, FLOATS, NAME, STRUCT_NAME, Field, Interface, Message, Schema, Struct

# Unit of the wire -> that of the value, and what the number is multiplied with, as it is written in every language.
SCALES = {"1e-7 deg": ("deg", "1e-7"), "mm": ("m", "1e-3"), "0.1": ("1", "0.1"), "ms": ("s", "1e-3"), "us": ("s", "1e-6")}
# Shared struct of the wire -> its value, which every library has by hand.
STANDARD = {"Pose2d": "Pose", "Pose3d": "Pose3d", "Bbox3d": "Size", "Point3d": "Vector", "Orientation3d": "Attitude"}
# What [[value]] need not define.
KNOWN = {*STANDARD.values(), "Velocity", "Quaternion"}
# Classes that every library has by hand, and what they do for the proxies derived from them.
BASES = {
    "Device": "Nothing more.",
    "Keeping": "Queues the values of a message until the program takes them.",
    "Mobile": "Knows whether the last command was a motion; stop(), and a stop before closing.",
    "Selecting": "Its data are of one of several messages, selected by send().",
}
# How a value is made: Expr.how, which tells what each means.
WAYS = ("is", "truth", "equals", "bit", "text", "convert", "gather", "make", "unpack", "each", "call", "time", "whole")
PLAIN = ("float", "int", "bool", "text", "bytes", "rgb", "rgba")


@dataclass(frozen=True)
class Type:
    """What a program gets or gives. `name` is one of PLAIN, of a value, or of a struct of the wire if `owner` is set."""

    name: str
    owner: str = ""
    is_list: bool = False
    optional: bool = False
    wire: str = ""              # scalar type on the wire of a number, or of the numbers of a list

    def element(self) -> Type:
        return Type(self.name, self.owner, False, self.optional, self.wire)


@dataclass(frozen=True)
class Path:
    """Fields, one in the other, from what `root` names: "" what is at hand, "message" the whole message, or a kept answer."""

    root: str
    fields: tuple[Field, ...]

    @property
    def names(self) -> list[str]:
        return [f.name for f in self.fields]

    @property
    def last(self) -> Field:
        return self.fields[-1]


@dataclass
class Expr:
    """How a value is made. `how` is one of:

    is            the field as it is; `factor` times it, if there is one; None if it equals `absent`
    truth         whether it is not 0
    equals, bit   whether it equals, or has the bit of, the constant
    text          of NUL-terminated bytes
    convert       the standard value, rgb or rgba of a struct; `type` says which
    gather        the Vector or Quaternion of several numbers, or a Pose3d of a Point3d and an Orientation3d
    make          a value of `parts`; one part per field
    unpack        a value of a list with one number per field
    each          `one` of each element of a list
    call          what a function that the library has by hand, `function`, makes of the paths
    time          the server's time of the message
    whole         all of it, as the struct of the wire
    """

    how: str
    type: Type
    paths: list[Path] = field(default_factory=list)
    factor: str = ""
    constant: str = ""
    absent: str = ""
    only_if: tuple[Path, str] | None = None     # flags and the constant that says whether there is a value
    function: str = ""
    parts: list[tuple[str, Expr]] = field(default_factory=list)
    one: Expr | None = None
    unit: str = ""

    @property
    def path(self) -> Path:
        return self.paths[0]

    def all(self) -> list[Expr]:
        """It and those that it is made of."""
        inner = [self.one] if self.one else []
        return [self, *(e for part in [*inner, *(part for _, part in self.parts)] for e in part.all())]

    @property
    def has_time(self) -> bool:
        return any(e.how == "time" for e in self.all())

    @property
    def has_outer(self) -> bool:
        """Whether it reads more of the message than what is at hand."""
        return any(path.root == "message" for e in self.all() for path in e.paths)


@dataclass
class Part:
    """A field of a value."""

    name: str
    type: Type | None = None    # known once the value is used
    doc: str = ""
    default: str = ""
    row: dict = field(default_factory=dict)


@dataclass
class Value:
    name: str
    doc: str
    fields: list[Part]
    by_hand: bool               # the libraries have the class, since it has methods
    source: str
    interface: str              # that defines it


@dataclass
class Read:
    """What is made of the newest data, of a kept answer, or of another read."""

    name: str
    doc: str
    expr: Expr
    messages: list[Message]                 # the newest of these; none: of a kept answer
    variants: list[Expr] = field(default_factory=list)  # one per message, if there are several
    updates: bool = False                   # what updates() gives
    as_method: bool = False                 # a method also where a library has properties
    kept: str = ""                          # the kept answer, if it is of one


@dataclass
class Shortcut:
    """A field of another read, or of the first element of its list, which may have none."""

    name: str
    doc: str
    read: Read
    field: str
    type: Type
    none: str = ""              # what is lacking if the list is empty; "": it is no list


@dataclass
class Argument:
    name: str
    type: Type
    doc: str = ""
    default: str = ""           # as in Python and TypeScript; a constant of the proxy is allowed
    least: int | None = None    # of a whole number that is checked before it is sent
    choice: tuple[str, str] | None = None   # constants of the interface for false and true


@dataclass
class Node:
    """A struct that a command or request sends: for each field what it is set to."""

    struct: Struct
    owner: str
    entries: list[tuple[Field, object]]     # an Argument, a list of Arguments one behind the other, a number, or a Node


@dataclass
class Call:
    """A command, or a request."""

    name: str
    doc: str
    message: Message
    arguments: list[Argument]
    payload: Node | Argument | None         # an Argument: the struct itself
    moves: list[str] | bool = False         # whether the base moves from then on: always, or if one of these is not 0
    answer: Expr | None = None              # what the answer of a request is made into
    then: list[str] = field(default_factory=list)   # kept answers that are requested again

    @property
    def is_command(self) -> bool:
        return self.message.kind == "CMD"


@dataclass
class Kept:
    """An answer that is requested at opening, and kept as it is."""

    name: str
    doc: str
    message: Message
    struct: Struct


@dataclass
class Take:
    """The queue of a Keeping proxy: what is made of each message."""

    name: str
    doc: str
    message: Message
    expr: Expr


@dataclass
class Constant:
    name: str
    value: int
    doc: str


@dataclass
class Proxy:
    interface: Interface
    name: str                   # of the class
    doc: str
    base: str
    by_hand: bool               # the libraries have the whole class
    of_robot: bool              # a robot has it: Robot opens it by name
    constants: list[Constant] = field(default_factory=list)
    kept: list[Kept] = field(default_factory=list)
    members: list[Read | Shortcut | Call | Take] = field(default_factory=list)

    @property
    def opener(self) -> str:
        """The method that opens it is named as the interface."""
        return self.interface.name

    @property
    def plural(self) -> str:
        name = self.interface.name
        return name + ("es" if name.endswith(("s", "ch")) else "s")

    @property
    def updates(self) -> Read | None:
        return next((m for m in self.members if isinstance(m, Read) and m.updates), None)


@dataclass
class Proxies:
    schema: Schema
    values: dict[str, Value]
    proxies: list[Proxy]        # by code

    def generated(self) -> list[Proxy]:
        return [p for p in self.proxies if not p.by_hand]

    def functions(self) -> set[str]:
        """What every library has by hand to convert what is of one interface alone."""
        return {e.function for p in self.proxies for m in p.members for root in made_by(m) for e in root.all() if e.function}

    def modules(self) -> list[Interface]:
        """Interfaces with a value or a proxy that is generated."""
        mine = {p.interface.name for p in self.generated()} | {v.interface for v in self.values.values() if not v.by_hand}
        return [i for i in self.schema.all() if i.name in mine]

    def proxy_of(self, interface: Interface) -> Proxy | None:
        return next((p for p in self.generated() if p.interface is interface), None)

    def values_of(self, interface: Interface) -> list[Value]:
        """Those that are generated, in the order of their definition."""
        return [v for v in self.values.values() if v.interface == interface.name and not v.by_hand]


def build_proxies(schema: Schema) -> Proxies:
    """Raises SchemaError."""
    values: dict[str, Value] = {}
    for interface in schema.all():
        for row in interface.value_rows:
            value = _value(interface, row)
            if value.name in values or value.name in KNOWN:
                raise SchemaError(f"{value.source}: is there twice")
            values[value.name] = value
    proxies = [_Builder(schema, values, i).build() for i in schema.interfaces if i.proxy_row]
    unique("interfaces/", "class of a proxy", [p.name for p in proxies])
    for value in values.values():
        for part in value.fields:
            if part.type is None and not value.by_hand:
                raise SchemaError(f"{value.source}: no proxy has such a value, so that the type of {part.name} is unknown")
    return Proxies(schema, values, proxies)


def _value(interface: Interface, row: dict) -> Value:
    where = f"{interface.source}: value {row.get('name', '?')}"
    keys(where, row, {"name", "doc"}, {"fields", "by_hand"})
    if not STRUCT_NAME.match(row["name"]):
        raise SchemaError(f"{where}: not a name in PascalCase")
    documented(where, row["doc"])
    parts = []
    for entry in row.get("fields", []):
        entry = {"name": entry} if isinstance(entry, str) else entry
        here = f"{where}: field {entry.get('name', '?')}"
        keys(here, entry, {"name"}, {"doc", "default", *SOURCE})
        _named(here, entry["name"])
        parts.append(Part(entry["name"], None, entry.get("doc", ""), str(entry.get("default", "")), entry))
    unique(where, "field", [p.name for p in parts])
    return Value(row["name"], row["doc"], parts, row.get("by_hand", False), where, interface.name)


def _named(where: str, name: str) -> None:
    if not NAME.match(name) or name != name.lower():
        raise SchemaError(f"{where}: {name!r} is not a name in lower case")


# Keys that say what a value or one of its fields is made of.
SOURCE = {"from", "as", "is", "bit", "absent", "only_if", "by", "of", "type"}
AS = ("bool", "text", "rgb", "rgba")


@dataclass
class _Scope:
    """Where the paths of a source begin."""

    struct: Struct | None
    message: Struct | None


class _Builder:
    """Makes the proxy of one interface."""

    def __init__(self, schema: Schema, values: dict[str, Value], interface: Interface) -> None:
        self.schema, self.values, self.interface = schema, values, interface
        self.constants = {name for group in interface.constants for name in group.values}
        self.kept: dict[str, Kept] = {}

    def build(self) -> Proxy:
        row, where = self.interface.proxy_row, f"{self.interface.source}: proxy"
        keys(where, row, {"class"}, {"doc", "base", "by_hand", "of_robot", "constant", "keep", "read", "shortcut", "call", "take"})
        by_hand = row.get("by_hand", False)
        if by_hand and row.keys() - {"class", "by_hand", "of_robot"}:
            raise SchemaError(f"{where}: one that is written by hand has nothing but its class")
        if not STRUCT_NAME.match(row["class"]):
            raise SchemaError(f"{where}: {row['class']!r} is not a name in PascalCase")
        if not by_hand:
            documented(where, row.get("doc", ""))
        one_of(where, "base", row.get("base", "Device"), BASES)
        proxy = Proxy(self.interface, row["class"], row.get("doc", ""), row.get("base", "Device"), by_hand, row.get("of_robot", True))
        for entry in row.get("constant", []):
            here = f"{where}: constant {entry.get('name', '?')}"
            keys(here, entry, {"name", "value", "doc"}, set())
            proxy.constants.append(Constant(entry["name"], entry["value"], entry["doc"]))
        self.own_constants = {c.name for c in proxy.constants}
        for entry in row.get("keep", []):
            self._keep(f"{where}: keep {entry.get('name', '?')}", entry)
        proxy.kept = list(self.kept.values())
        for kind, made in (("read", self._read), ("shortcut", self._shortcut), ("take", self._take), ("call", self._call)):
            for entry in row.get(kind, []):
                here = f"{where}: {kind} {entry.get('name', '?')}"
                if "name" in entry:
                    _named(here, entry["name"])
                proxy.members.append(made(here, entry) if kind != "shortcut" else self._shortcut(here, entry, proxy))
        unique(where, "member", [m.name for m in proxy.members] + list(self.kept))
        if sum(isinstance(m, Read) and m.updates for m in proxy.members) > 1:
            raise SchemaError(f"{where}: updates() gives one value: more than one read says updates")
        if (proxy.base == "Keeping") != any(isinstance(m, Take) for m in proxy.members):
            raise SchemaError(f"{where}: base Keeping and [[proxy.take]] go together")
        return proxy

    # Messages and fields

    def _message(self, where: str, kind: str, name: str) -> Message:
        known = {m.name: m for m in self.interface.messages if m.kind == kind}
        one_of(where, f"message of kind {kind}", name, known)
        return known[name]

    def _payload(self, where: str, message: Message) -> Struct:
        struct = self.schema.interface(message.owner).struct(message.payload) if message.payload else None
        if struct is None:
            raise SchemaError(f"{where}: {message.label} has no payload")
        return struct

    def _path(self, where: str, text: str, scope: _Scope) -> Path:
        """"pose.px"; "/mode" from the whole message; "config:max_range" from a kept answer."""
        root, struct = "", scope.struct
        if ":" in text:
            root, _, text = text.partition(":")
            one_of(where, "kept answer", root, self.kept)
            struct = self.kept[root].struct
        elif text.startswith("/"):
            root, text, struct = "message", text[1:], scope.message
        fields: list[Field] = []
        for name in text.split("."):
            if struct is None:
                raise SchemaError(f"{where}: {text!r}: there is no struct that could have {name!r}")
            known = {f.name: f for f in struct.fields}
            one_of(f"{where}: struct {struct.name}", "field", name, known)
            fields.append(known[name])
            f = known[name]
            struct = None if f.is_scalar or f.is_array else self.schema.struct_of(f)
        return Path(root, tuple(fields))

    def _constant(self, where: str, name: str) -> str:
        one_of(where, f"constant of {self.interface.name}", name, sorted(self.constants))
        return name

    # What a value is made of

    def _source(self, where: str, row: dict, name: str, scope: _Scope) -> Expr:
        if "by" in row:
            return self._called(where, row, scope)
        origin = row.get("from", name)
        if origin == "time" and "from" not in row and (scope.struct is None or all(f.name != "time" for f in scope.struct.fields)):
            return Expr("time", Type("float", wire="float64"), unit="s")
        if isinstance(origin, list):
            return self._gathered(where, [self._path(where, text, scope) for text in origin])
        path = self._path(where, origin, scope)
        expr = self._of_field(where, row, path)
        if "absent" in row:
            expr.absent = str(row["absent"])
            expr.type = Type(expr.type.name, expr.type.owner, expr.type.is_list, True, expr.type.wire)
        return self._if(where, row, expr, scope)

    def _if(self, where: str, row: dict, expr: Expr, scope: _Scope) -> Expr:
        if "only_if" in row:
            flags, constant = row["only_if"]
            expr.only_if = (self._path(where, flags, scope), self._constant(where, constant))
            expr.type = Type(expr.type.name, expr.type.owner, expr.type.is_list, True, expr.type.wire)
        return expr

    def _called(self, where: str, row: dict, scope: _Scope) -> Expr:
        if not NAME.match(row["by"]) or "type" not in row or "from" in row:
            raise SchemaError(f"{where}: by names a function; of are the fields that it is called with, type is what it gives")
        paths = [self._path(where, text, scope) for text in row.get("of", [])]
        return self._if(where, row, Expr("call", self._type(where, row["type"]), paths, function=row["by"]), scope)

    def _type(self, where: str, text: str) -> Type:
        name, is_list = text.removesuffix("[]"), text.endswith("[]")
        one_of(where, "type", name, [*PLAIN, *KNOWN, *self.values])
        return Type(name, is_list=is_list, wire="float64" if name == "float" else "")

    def _of_field(self, where: str, row: dict, path: Path) -> Expr:
        f, kind = path.last, row.get("as", "")
        if "is" in row or "bit" in row:
            how, constant = ("equals", row["is"]) if "is" in row else ("bit", row["bit"])
            if not f.is_scalar or f.is_array:
                raise SchemaError(f"{where}: {f.name} is no number, which is and bit are for")
            return Expr(how, Type("bool"), [path], constant=self._constant(where, constant))
        if kind in self.values:
            return self._unpacked(where, self.values[kind], path)
        if kind:
            one_of(where, "as", kind, [*AS, *self.values])
        if kind == "text" or f.is_text:
            return Expr("text", Type("text"), [path], unit=f.unit)
        if kind == "bool":
            if not f.is_scalar:
                raise SchemaError(f"{where}: {f.name} is no number")
            one = Expr("truth", Type("bool", wire=f.type), [] if f.is_array else [path])
            return Expr("each", Type("bool", is_list=True, wire=f.type), [path], one=one) if f.is_array else one
        if f.is_raw:
            return Expr("is", Type("bytes"), [path])
        if f.is_scalar:
            unit, factor = SCALES.get(f.unit, (f.unit, ""))
            name = "float" if f.type in FLOATS or factor else "int"
            if factor and f.is_array:
                raise SchemaError(f"{where}: {f.name}: a list of numbers in {f.unit} is not supported")
            return Expr("is", Type(name, is_list=f.is_array, wire=f.type), [path], factor=factor, unit=unit)
        return self._of_struct(where, kind, path)

    def _of_struct(self, where: str, kind: str, path: Path) -> Expr:
        f = path.last
        if f.type == "Color" and kind in ("rgb", "rgba"):
            type_ = Type(kind)
        elif f.owner == COMMON and f.type in STANDARD:
            name = STANDARD[f.type]
            type_ = Type("Velocity" if name == "Pose" and f.unit.startswith("m/s") else name)
        else:
            return Expr("whole", Type(f.type, f.owner, f.is_array), [path])
        if not f.is_array:
            return Expr("convert", type_, [path], unit=f.unit)
        return Expr("each", Type(type_.name, is_list=True), [path], one=Expr("convert", type_, []), unit=f.unit)

    def _gathered(self, where: str, paths: list[Path]) -> Expr:
        kinds = [p.last.type for p in paths]
        numbers = all(p.last.type in FLOATS and not p.last.is_array for p in paths)
        if kinds == ["Point3d", "Orientation3d"]:
            return Expr("gather", Type("Pose3d"), paths)
        if numbers and len(paths) in (3, 4):
            return Expr("gather", Type("Vector" if len(paths) == 3 else "Quaternion"), paths, unit=paths[0].last.unit)
        raise SchemaError(f"{where}: from is one field, three or four numbers, or a Point3d and an Orientation3d")

    def _unpacked(self, where: str, value: Value, path: Path) -> Expr:
        if path.last.length != len(value.fields) or path.last.type not in FLOATS:
            raise SchemaError(f"{where}: {path.last.name} is no list of {len(value.fields)} numbers, as {value.name} has")
        for part in value.fields:
            part.type = Type("float", wire=path.last.type)
        return Expr("unpack", Type(value.name), [path], unit=path.last.unit)

    def _made(self, where: str, row: dict, name: str, scope: _Scope) -> Expr:
        """Of a row with `value`: that value, or a list of it; else what a field is made into."""
        if "value" not in row:
            if "from" not in row and not row.keys() & (SOURCE - {"type"}):
                assert scope.struct is not None
                return Expr("whole", Type(scope.struct.name, self._owner_of(scope.struct)), [])
            return self._source(where, row, name, scope)
        one_of(where, "value", row["value"], self.values)
        value = self.values[row["value"]]
        if "from" not in row:
            return self._make(where, value, row, scope)
        path = self._path(where, row["from"], scope)
        if path.last.is_scalar:
            raise SchemaError(f"{where}: {path.last.name} is no struct that {value.name} could be made of")
        inner = _Scope(self.schema.struct_of(path.last), scope.message)
        one = self._make(where, value, row, inner)
        if not path.last.is_array:
            raise SchemaError(f"{where}: {path.last.name} is no list")
        return Expr("each", Type(value.name, is_list=True), [path], one=one)

    def _make(self, where: str, value: Value, row: dict, scope: _Scope) -> Expr:
        changed = row.get("fields", {})
        for name in changed:
            one_of(where, f"field of {value.name}", name, [p.name for p in value.fields])
        parts = []
        for part in value.fields:
            here = f"{where}: {value.name}.{part.name}"
            source = changed.get(part.name, part.row)
            source = {"from": source} if isinstance(source, str) else source
            expr = self._part(here, source, part, scope)
            known = part.type
            if known is not None and (known.name, known.is_list) != (expr.type.name, expr.type.is_list):
                raise SchemaError(f"{here}: is a {known.name} elsewhere, and a {expr.type.name} here")
            part.type = part.type or expr.type
            part.doc = part.doc or _described(expr)
            parts.append((part.name, expr))
        return Expr("make", Type(value.name), parts=parts)

    def _part(self, where: str, source: dict, part: Part, scope: _Scope) -> Expr:
        """A list of values in a value is one whose `as` names it with [], as "Joint[]"."""
        kind = source.get("as", "")
        if not kind.endswith("[]"):
            return self._source(where, source, part.name, scope)
        return self._made(where, {"value": kind[:-2], "from": source.get("from", part.name)}, part.name, scope)

    def _owner_of(self, struct: Struct) -> str:
        return next(i.name for i in self.schema.all() if struct in i.structs)

    # Members

    def _keep(self, where: str, row: dict) -> None:
        keys(where, row, {"name", "message", "doc"}, set())
        documented(where, row["doc"])
        message = self._message(where, "REQ", row["message"])
        self.kept[row["name"]] = Kept(row["name"], row["doc"], message, self._payload(where, message))

    def _read(self, where: str, row: dict) -> Read:
        keys(where, row, {"name"}, {"message", "messages", "kept", "value", "fields", "doc", "updates", "method", *SOURCE})
        if sum(key in row for key in ("message", "messages", "kept")) != 1:
            raise SchemaError(f"{where}: of one of message, messages and kept")
        made = Read(row["name"], row.get("doc", ""), Expr("", Type("")), [], [], row.get("updates", False), row.get("method", False))
        if "kept" in row:
            one_of(where, "kept answer", row["kept"], self.kept)
            made.kept, struct = row["kept"], self.kept[row["kept"]].struct
            made.expr = self._made(where, row, row["name"], _Scope(struct, struct))
            return made
        sources = row.get("messages", {row.get("message"): None})
        for name, inside in sources.items():
            message = self._message(where, "DATA", name)
            struct = self._payload(where, message)
            scope = _Scope(struct, struct)
            if inside is not None:
                made.variants.append(self._variant(where, row, inside, scope))
            else:
                made.expr = self._made(where, row, row["name"], scope)
            made.messages.append(message)
        if made.variants:
            made.expr = made.variants[0]
            if {v.type for v in made.variants} != {made.expr.type}:
                raise SchemaError(f"{where}: the messages give values of different types")
        return made

    def _variant(self, where: str, row: dict, inside: str, scope: _Scope) -> Expr:
        """One of several messages: of the field `inside` of it, or "" of itself."""
        if "value" not in row:
            return self._source(where, row | {"from": inside}, row["name"], scope)
        one_of(where, "value", row["value"], self.values)
        if not inside:
            return self._make(where, self.values[row["value"]], row, scope)
        path = self._path(where, inside, scope)
        made = self._make(where, self.values[row["value"]], row, _Scope(self.schema.struct_of(path.last), scope.message))
        return Expr("make", made.type, [path], parts=made.parts)

    def _shortcut(self, where: str, row: dict, proxy: Proxy) -> Shortcut:
        keys(where, row, {"name", "of"}, {"doc", "none"})
        read_name, _, part_name = row["of"].partition(".")
        reads = {m.name: m for m in proxy.members if isinstance(m, Read)}
        one_of(where, "read", read_name, reads)
        read = reads[read_name]
        if read.expr.type.is_list != ("none" in row):
            raise SchemaError(f"{where}: none says what is lacking if a list is empty, and only of a list")
        parts = {p.name: p for p in self.values[read.expr.type.name].fields} if read.expr.type.name in self.values else {}
        one_of(where, f"field of {read.expr.type.name}", part_name, parts)
        part_type = parts[part_name].type
        assert part_type is not None
        return Shortcut(row["name"], row.get("doc", ""), read, part_name, part_type, row.get("none", ""))

    def _take(self, where: str, row: dict) -> Take:
        keys(where, row, {"name", "message", "doc", "from"}, {"as"})
        message = self._message(where, "DATA", row["message"])
        struct = self._payload(where, message)
        return Take(row["name"], row["doc"], message, self._source(where, row, row["name"], _Scope(struct, struct)))

    def _call(self, where: str, row: dict) -> Call:
        keys(where, row, {"name"}, {"command", "request", "doc", "arguments", "set", "moves", "value", "fields", "then", "answer", *SOURCE})
        if ("command" in row) == ("request" in row):
            raise SchemaError(f"{where}: is either a command or a request")
        message = self._message(where, "CMD", row["command"]) if "command" in row else self._message(where, "REQ", row["request"])
        if row.get("doc"):
            documented(where, row["doc"])
        made = Call(row["name"], row.get("doc", ""), message, [], None, row.get("moves", False))
        entries: dict = {}
        for entry in row.get("arguments", []):
            self._argument(f"{where}: argument {entry.get('name', '?')}", entry, made, entries)
        for target, value in row.get("set", {}).items():
            _place(f"{where}: set {target}", entries, target, value)
        if entries:
            made.payload = self._node(where, self._payload(where, message), message.owner, entries)
        if not isinstance(made.moves, bool):
            for name in made.moves:
                one_of(where, "argument", name, [a.name for a in made.arguments])
        if row.get("answer") or row.keys() & ({"value"} | SOURCE):
            struct = self._payload(where, message)
            made.answer = self._made(where, row, row["name"], _Scope(struct, struct))
        for name in row.get("then", []):
            one_of(where, "kept answer", name, self.kept)
        made.then = row.get("then", [])
        return made

    def _argument(self, where: str, row: dict, call: Call, entries: dict) -> None:
        keys(where, row, {"name"}, {"to", "as", "doc", "default", "least", "choice"})
        _named(where, row["name"])
        target = row.get("to", row["name"])
        default = str(row.get("default", ""))
        if re.match(r"[A-Z]", default):
            one_of(where, "constant of the proxy", default, sorted(self.own_constants))
        struct = self._payload(where, call.message)
        argument = Argument(row["name"], Type(""), row.get("doc", ""), default, row.get("least"))
        if target == "*":
            argument.type = Type(struct.name, call.message.owner)
            call.payload = argument
        else:
            path = self._path(where, target, _Scope(struct, struct))
            argument.type = self._argument_type(where, row, path)
            if "choice" in row:
                no, yes = (self._constant(where, name) for name in row["choice"])
                argument.choice, argument.type = (no, yes), Type("bool", wire=path.last.type)
            _place(where, entries, target, argument)
        call.arguments.append(argument)

    def _argument_type(self, where: str, row: dict, path: Path) -> Type:
        f, kind = path.last, row.get("as", "")
        if f.is_scalar and not f.is_array and kind == "bool":
            return Type("bool", wire=f.type)
        if kind == "Attitude" and f.type in ("Pose3d", "Orientation3d"):
            return Type(kind)
        if kind in self.values:
            self._unpacked(where, self.values[kind], path)
            return Type(kind, wire=f.type)
        expr = self._of_field(where, {"as": kind} if kind else {}, path)
        if expr.factor:
            raise SchemaError(f"{where}: {f.name} in {f.unit} cannot be an argument yet")
        return expr.type

    def _node(self, where: str, struct: Struct, owner: str, entries: dict) -> Node:
        known = {f.name: f for f in struct.fields}
        made = []
        for name, value in sorted(entries.items(), key=lambda e: list(known).index(e[0]) if e[0] in known else -1):
            one_of(f"{where}: struct {struct.name}", "field", name, known)
            f = known[name]
            if isinstance(value, dict):
                value = self._node(where, self.schema.struct_of(f), f.owner, value)
            elif isinstance(value, list) and not f.is_raw:
                raise SchemaError(f"{where}: two arguments for {name}")
            made.append((f, value))
        return Node(struct, owner, made)


def _place(where: str, entries: dict, target: str, value) -> None:
    *outer, name = target.split(".")
    for part in outer:
        entries = entries.setdefault(part, {})
        if not isinstance(entries, dict):
            raise SchemaError(f"{where}: {part} is set as a whole already")
    if name in entries and isinstance(entries[name], (Argument, list)) and isinstance(value, Argument):
        entries[name] = (entries[name] if isinstance(entries[name], list) else [entries[name]]) + [value]
    elif name in entries:
        raise SchemaError(f"{where}: {name} is set twice")
    else:
        entries[name] = value


def _described(expr: Expr) -> str:
    """What the field of the wire says of itself, with the unit of the value."""
    if expr.how == "time":
        return "The server's time (in s)."
    if expr.how == "each" or expr.paths == []:
        return expr.path.last.doc if expr.paths else ""
    doc = expr.path.last.doc if len(expr.paths) == 1 and expr.how in ("is", "text", "convert", "unpack") else ""
    if not expr.unit or expr.unit == "1":
        return doc
    return f"{doc[:-1]} (in {expr.unit})." if doc else f"In {expr.unit}."


def made_by(member) -> list[Expr]:
    """What a member makes of what it receives."""
    if isinstance(member, Call):
        return [member.answer] if member.answer else []
    if isinstance(member, Read):
        return member.variants or [member.expr]
    return [member.expr] if isinstance(member, Take) else []


# {drive()}, {State.pose}, {set_power(true)} and {raises NoData} in a doc: names as each language spells them.
MARK = re.compile(r"\{(?:(raises) )?([A-Za-z_0-9.]+)(\([^)]*\))?\}")


def spelled(doc: str, name, raises) -> str:
    """The doc for a language: `name` spells a member or Value.field with its call, `raises` what is raised."""
    return MARK.sub(lambda m: raises(m[2]) if m[1] else name(m[2], m[3] or ""), doc)
