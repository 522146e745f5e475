"""Writes clients/python/playhouse_client/generated/: one module per interface, standard library only.

A module has the interface's constants, one dataclass per struct, and one MessageType per message, with Player's
name without the prefix (PLAYER_POSITION2D_CMD_VEL is position2d.CMD_VEL).
"""

from __future__ import annotations

import keyword
import textwrap

from codegen.checks import SchemaError
from codegen.model import COMMON, OPAQUE, SCALARS, Constants, Field, Interface, Message, Schema, Struct

FOLDER = "clients/python/playhouse_client/generated"
WIDTH = 110

# Scalar type -> its letter in playhouse_client.wire (those of the struct module).
CODES = {
    "char": "b", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i", "uint32": "I",
    "int64": "q", "float32": "f", "float64": "d",
}


def emit(schema: Schema) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files = {f"{FOLDER}/{i.name}.py": _module(schema, i) for i in schema.all()}
    files[f"{FOLDER}/__init__.py"] = _index(schema)
    return files


def _module(schema: Schema, interface: Interface) -> str:
    _check_names(interface)
    shared = interface.code is None
    title = "What every interface shares" if shared else f"Interface {interface.name}, code {interface.code}"
    about = f"Generated from {interface.source} by codegen; do not edit."
    parts = [f'"""{_wrapped(f"{title}. {interface.doc}", 0)}\n\n{about}\n"""\n']
    parts.append(_imports(interface))
    if not shared:
        parts.append(f"CODE = {interface.code}\n")
    parts += [_constants_text(interface, c) for c in interface.constants]
    parts += [_struct(schema, interface, s) for s in interface.in_order()]
    if interface.messages:
        parts.append("\n" + "\n".join(_message(interface, m) for m in interface.messages) + "\n")
    return "\n".join(parts)


def _check_names(interface: Interface) -> None:
    names = [s.name for s in interface.structs] + [m.constant for m in interface.messages]
    names += [interface.constant(n) for c in interface.constants for n in c.values]
    for name in names:
        if names.count(name) > 1 or name == "CODE":
            raise SchemaError(f"{interface.source}: {name} would stand for two things in Python")
    for s in interface.structs:
        for f in s.fields:
            if keyword.iskeyword(f.name) or f.name in ("encode", "decode", "read", "write"):
                raise SchemaError(f"{interface.source}: {s.name}.{f.name} cannot be a field in Python")


def _imports(interface: Interface) -> str:
    fields = [f for s in interface.structs for f in s.fields]
    lines = []
    if fields:
        needs_field = any(not _plain_default(f) for f in fields)
        lines.append("from dataclasses import dataclass" + (", field" if needs_field else ""))
    if any(_is_list(f) for f in fields):
        lines.append("from typing import List")
    if lines:
        lines.append("")
    names = ["Kind", "MessageType"] if interface.messages else []
    names += ["Reader", "Struct", "Writer"] if fields else []
    owners = {f.owner for f in fields} | {m.owner for m in interface.messages}
    lines += [f"from . import {owner}" for owner in sorted(owners - {"", interface.name})]
    lines.append(f"from ..wire import {', '.join(names)}")
    return "\n".join(lines) + "\n"


def _constants_text(interface: Interface, constants: Constants) -> str:
    lines = [f"# {line}" for line in textwrap.wrap(constants.doc, WIDTH - 2)]
    lines += [f"{interface.constant(name)} = {value}" for name, value in constants.values.items()]
    return "\n".join(lines) + "\n"


def _struct(schema: Schema, interface: Interface, s: Struct) -> str:
    about = _wrapped(f"{s.doc} ({s.c_name})", 4)
    lines = ["", "@dataclass", f"class {s.name}(Struct):", f'    """{about}"""', ""]
    for f in s.fields:
        lines += _field_comment(f)
        lines.append(f"    {f.name}: {_type(interface, f)} = {_default(interface, f)}")
    lines += ["", "    def write(self, writer: Writer) -> None:"]
    for step, f in s.steps():
        lines += ["        " + line for line in (_write_count(f) if step == "count" else _write(f))]
    lines += ["", "    @classmethod", f'    def read(cls, reader: Reader) -> "{s.name}":']
    lines.append("        self = cls()")
    for step, f in s.steps():
        step_lines = _read_count(f) if step == "count" else _read(schema, interface, f)
        lines += ["        " + line for line in step_lines]
    lines += ["        return self", ""]
    return "\n".join(lines)


def _field_comment(f: Field) -> list[str]:
    return [f"    # {line}" for line in textwrap.wrap(f.described(), WIDTH - 6)]


def _is_list(f: Field) -> bool:
    return f.is_array and not f.is_raw


def _plain_default(f: Field) -> bool:
    return f.is_raw or (f.is_scalar and not f.is_array)


def _class(interface: Interface, f: Field) -> str:
    return f.type if f.owner == interface.name else f"{f.owner}.{f.type}"


def _type(interface: Interface, f: Field) -> str:
    if f.is_raw:
        return "bytes"
    one = ("float" if f.type.startswith("float") else "int") if f.is_scalar else _class(interface, f)
    return f"List[{one}]" if f.is_array else one


def _default(interface: Interface, f: Field) -> str:
    zero = "0.0" if f.type.startswith("float") else "0"
    if f.is_raw:
        return 'b""'
    if not f.is_array:
        return zero if f.is_scalar else f"field(default_factory={_class(interface, f)})"
    if f.length is None:
        return "field(default_factory=list)"
    one = zero if f.is_scalar else f"{_class(interface, f)}()"
    return f"field(default_factory=lambda: [{one} for _ in range({f.length})])"


def _write_count(f: Field) -> list[str]:
    return [f'writer.length("{f.name}", len(self.{f.name}), {f.max})']


def _write(f: Field) -> list[str]:
    lines = _write_count(f) if f.has_count else []
    me = f"self.{f.name}"
    if f.is_raw:
        if f.length is not None:
            return [f'writer.fixed("{f.name}", {me}, {f.length})']
        return lines + [f"writer.opaque({me})"]
    if not f.is_array:
        return [f'writer.number("{CODES[f.type]}", {me})' if f.is_scalar else f"{me}.write(writer)"]
    if f.length is not None:
        lines.append(f'writer.exactly("{f.name}", len({me}), {f.length})')
    if f.is_scalar:
        return lines + [f'writer.numbers("{CODES[f.type]}", {me})']
    return lines + [f"for item in {me}:", "    item.write(writer)"]


def _read_count(f: Field) -> list[str]:
    return [f'{_count(f)} = reader.number("I")' if f.dynamic else 'reader.number("I")']


def _count(f: Field) -> str:
    return f.count_name


def _read(schema: Schema, interface: Interface, f: Field) -> list[str]:
    me = f"self.{f.name}"
    if not f.is_array:
        one = f'reader.number("{CODES[f.type]}")' if f.is_scalar else f"{_class(interface, f)}.read(reader)"
        return [f"{me} = {one}"]
    length = str(f.length)
    if f.length is None:
        least = 1 if f.type in OPAQUE else SCALARS[f.type] if f.is_scalar else schema.struct_of(f).min_bytes
        length = f'reader.length("{f.name}", {_count(f) if f.dynamic else f.max}, {least})'
    if f.is_raw:
        return [f"{me} = reader.opaque({length})"]
    if f.is_scalar:
        return [f'{me} = reader.numbers("{CODES[f.type]}", {length})']
    if f.length is None:
        return [f"{f.name}_length = {length}",
                f"{me} = [{_class(interface, f)}.read(reader) for _ in range({f.name}_length)]"]
    return [f"{me} = [{_class(interface, f)}.read(reader) for _ in range({length})]"]


def _message(interface: Interface, m: Message) -> str:
    payload = m.payload if m.owner == interface.name else f"{m.owner}.{m.payload}"
    name = interface.full_name(m)
    doc = "\n".join(f"# {line}" for line in textwrap.wrap(m.doc, WIDTH - 2))
    row = [str(interface.code or 0), f"Kind.{m.kind}", str(m.subtype), f'"{name}"']
    row += [payload] if m.payload else []
    made = f"{m.constant} = MessageType({', '.join(row)})"
    if len(made) > WIDTH:
        made = f"{m.constant} = MessageType(\n    {', '.join(row)}\n)"
    return f"{doc}\n{made}" if doc else made


def _index(schema: Schema) -> str:
    names = [i.name for i in schema.interfaces]
    listed = "\n".join(f"    {name}," for name in names)
    rows = "\n".join(f'    {i.code}: "{i.name}",' for i in schema.interfaces)
    return f'''"""Every interface of the Player protocol: values, and their encoding and decoding.

Generated from interfaces/ by codegen; do not edit.
"""

from typing import Dict, Optional

from ..wire import Kind, MessageType
from . import {COMMON}
from . import (
{listed}
)

# Code of an interface -> its name.
INTERFACES: Dict[int, str] = {{
{rows}
}}

_MODULES = (
{listed}
)


def _catalogue() -> Dict[tuple, MessageType]:
    rows = {{}}
    for module in ({COMMON},) + _MODULES:
        for value in vars(module).values():
            if isinstance(value, MessageType):
                rows[(value.interface, value.kind, value.subtype)] = value
    return rows


_CATALOGUE = _catalogue()


def find_message(interface: int, kind: int, subtype: int) -> Optional[MessageType]:
    """The row of a message, or None. Answers have the row of their request; shared messages apply to every interface."""
    if kind in (Kind.ACK, Kind.NACK):
        kind = Kind.REQ
    return _CATALOGUE.get((0, kind, subtype)) or _CATALOGUE.get((interface, kind, subtype))
'''


def _wrapped(text: str, indent: int) -> str:
    lines = textwrap.wrap(text.strip(), WIDTH - indent - 6)
    return ("\n" + " " * indent).join(lines)
