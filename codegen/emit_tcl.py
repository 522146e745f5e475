"""Writes clients/tcl/generated/: one file per interface, for plain Tcl 8.6.

A file has the interface's constants as variables of its namespace, a `struct` per struct and a `message` per message;
clients/tcl/wire.tcl defines these commands and those that the bodies call. A value is a dictionary in wire order; text
and lists of bytes are byte strings. Parts of fixed size are read by one `binary scan`.
"""

from __future__ import annotations

import textwrap
from dataclasses import dataclass

from codegen.checks import SchemaError
from codegen.model import OPAQUE, SCALARS, Constants, Field, Interface, Message, Schema, Struct

FOLDER = "clients/tcl/generated"
WIDTH = 110

# Scalar type -> its letter of `binary scan`, which also converts whole lists.
SCAN = {
    "char": "I", "int8": "I", "uint8": "Iu", "int16": "I", "uint16": "Iu", "int32": "I", "uint32": "Iu",
    "int64": "W", "float32": "R", "float64": "Q",
}
# Types narrower than their word on the wire -> what a receiver makes of it.
NARROW = {"char": "signed 0x80", "int8": "signed 0x80", "uint8": "low 0xff", "int16": "signed 0x8000", "uint16": "low 0xffff"}


def emit(schema: Schema) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {f"{FOLDER}/{i.name}.tcl": _file(schema, i) for i in schema.all()}


def _file(schema: Schema, interface: Interface) -> str:
    _check_names(interface)
    shared = interface.code is None
    title = "What every interface shares" if shared else f"Interface {interface.name}, code {interface.code}"
    lines = _comment(f"{title}. {interface.doc}") + ["#"]
    lines += _comment(f"Generated from {interface.source} by codegen; do not edit.")
    lines += ["", f"::playhouse::wire::interface {interface.name} {interface.code or 0} {{"]
    blocks = [_constants(c) for c in interface.constants]
    blocks += [_struct(schema, interface, s) for s in interface.structs]
    if interface.messages:
        blocks.append([line for m in interface.messages for line in _message(interface, m)])
    lines += [f"    {line}".rstrip() for line in _spaced(blocks)]
    return "\n".join(lines + ["}"]) + "\n"


def _check_names(interface: Interface) -> None:
    for s in interface.structs:
        for f in s.fields:
            if f.name in ("body", "at"):
                raise SchemaError(f"{interface.source}: {s.name}.{f.name} cannot be a field in Tcl")
    if any(name == "CODE" for c in interface.constants for name in c.values):
        raise SchemaError(f"{interface.source}: CODE would stand for two things in Tcl")


def _spaced(blocks: list[list[str]]) -> list[str]:
    return [line for block in blocks for line in ["", *block]][1:]


def _comment(text: str, indent: str = "") -> list[str]:
    """Braces count even in a comment inside of a braced script, and a comment goes on after a backslash."""
    if any(c in text for c in "{}\\"):
        raise SchemaError(f"{text!r} cannot be a comment in Tcl")
    return [f"# {line}" for line in textwrap.wrap(indent + text.strip(), WIDTH - 6, subsequent_indent=indent + "  " * bool(indent))]


def _constants(constants: Constants) -> list[str]:
    return _comment(constants.doc) + [f"variable {name} {value}" for name, value in constants.values.items()]


def _message(interface: Interface, m: Message) -> list[str]:
    name = interface.full_name(m)
    payload = f" {m.owner}.{m.payload}" if m.payload else ""
    return (_comment(m.doc) if m.doc else []) + [f"message {name} {m.kind} {m.subtype}{payload}"]


def _struct(schema: Schema, interface: Interface, s: Struct) -> list[str]:
    lines = _comment(f"{s.doc} ({s.c_name})")
    for f in s.fields:
        lines += _field_comment(f)
    types = [f"    {f.name} {_type(f)}" for f in s.fields]
    read = _Reading(schema, interface).struct(s)
    write = [line for step, f in s.steps() for line in (_write_count(f) if step == "count" else _write(interface, f))]
    lines += [f"struct {s.name} {{", *types, "} {", *(f"    {line}" for line in read), "} {"]
    return lines + [*(f"    {line}" for line in write), "    return $out", "}"]


def _field_comment(f: Field) -> list[str]:
    unit = f"in {f.unit}" if f.unit and f.unit != "1" else ""
    quantity = ", ".join(part for part in (unit, f"frame {f.frame}" if f.frame else "") if part)
    doc = f.doc.strip().rstrip(".")
    text = f"{doc} ({quantity})" if doc and quantity else doc or quantity
    return _comment(f"{f.name}: {text}.", "  ") if text else []


def _type(f: Field) -> str:
    one = f.type if f.is_scalar else f"{f.owner}.{f.type}"
    return f"{one}[{f.length or ''}]" if f.is_array else one


def _command(interface: Interface, f: Field, verb: str) -> str:
    return f"{f.type}.{verb}" if f.owner == interface.name else f"{f.owner}::{f.type}.{verb}"


def _var(name: str) -> str:
    return f"${{{name}}}" if "." in name else f"${name}"


@dataclass
class _Part:
    """A part of fixed size: its bytes, its letters of `binary scan`, its variable (none: skipped) and what it becomes."""

    size: int
    letters: str
    variable: str
    narrow: str = ""


class _Reading:
    """Makes the body that reads a struct: parts of fixed size are gathered until one of another size follows."""

    def __init__(self, schema: Schema, interface: Interface) -> None:
        self._schema, self._interface = schema, interface
        self._parts: list[_Part] = []
        self._lines: list[str] = []

    def struct(self, s: Struct) -> list[str]:
        for step, f in s.steps():
            if step == "count":
                self._parts.append(_Part(4, "Iu" if f.dynamic else "x4", f"{f.name}.count" if f.dynamic else ""))
            elif not self._gather(f, f.name):
                self._flush()
                self._read(f)
        self._flush()
        return self._lines + self._dict(s, "").split("\n")

    def _gather(self, f: Field, name: str) -> bool:
        """Adds a field of fixed size to the parts; false for any other."""
        if f.has_count or not (f.is_scalar or self._is_flat(f)):
            return False
        if not f.is_scalar:
            return all(self._gather(inner, f"{name}.{inner.name}") for inner in self._schema.struct_of(f).fields)
        if f.is_raw:
            padding = -f.length % 4
            self._parts.append(_Part(f.length + padding, f"a{f.length}" + f"x{padding}" * bool(padding), name))
        else:
            length = "" if f.length is None else str(f.length)
            narrow = NARROW.get(f.type, "")
            self._parts.append(_Part(SCALARS[f.type] * (f.length or 1), SCAN[f.type] + length, name,
                                     narrow if f.length is None else narrow.replace(" ", "s ", 1)))
        return True

    def _is_flat(self, f: Field) -> bool:
        """Whether a field is one struct of fixed size."""
        return not f.is_array and all(not inner.has_count and (inner.is_scalar or self._is_flat(inner))
                                      for inner in self._schema.struct_of(f).fields)

    def _flush(self) -> None:
        if not self._parts:
            return
        total = sum(part.size for part in self._parts)
        sizes = " ".join(str(part.size) for part in self._parts)
        self._lines += _wrapped(f"if {{[string length $body] - $at < {total}}} {{cut $body $at {{{sizes}}}}}")
        letters = "".join(part.letters for part in self._parts)
        names = " ".join(part.variable for part in self._parts if part.variable)
        if names:
            self._lines += _wrapped(f"binary scan $body @${{at}}{letters} {names}")
        self._lines.append(f"incr at {total}")
        self._lines += [f"set {p.variable} [{p.narrow} {_var(p.variable)}]" for p in self._parts if p.narrow]
        self._parts = []

    def _read(self, f: Field) -> None:
        if not f.is_array:
            self._lines.append(f"set {f.name} [{_command(self._interface, f, 'read')} $body]")
            return
        length = str(f.length)
        if f.length is None:
            least = 1 if f.type in OPAQUE else SCALARS[f.type] if f.is_scalar else self._schema.struct_of(f).min_bytes
            limit = f"${{{f.name}.count}}" if f.dynamic else f.max
            length = f"[length $body {f.name} {limit} {least}]"
        if f.is_raw:
            self._lines.append(f"set {f.name} [opaque $body {length}]")
        elif f.is_scalar:
            narrow = NARROW.get(f.type, "").replace(" ", "s ", 1)
            values = f"[numbers $body {SCAN[f.type]} {SCALARS[f.type]} {length}]"
            self._lines.append(f"set {f.name} " + (f"[{narrow} {values}]" if narrow else values))
        else:
            reader = _command(self._interface, f, "read")
            self._lines += [f"set {f.name} {{}}",
                            f"for {{set {f.name}.left {length}}} {{${{{f.name}.left}} > 0}} {{incr {f.name}.left -1}} {{",
                            f"    lappend {f.name} [{reader} $body]", "}"]

    def _dict(self, s: Struct, prefix: str) -> str:
        parts = []
        for f in s.fields:
            flat = not f.is_scalar and self._is_flat(f)
            inner = self._dict(self._schema.struct_of(f), f"{prefix}{f.name}.") if flat else _var(prefix + f.name)
            parts.append(f"{f.name} {inner}")
        if prefix:
            return f"[dict create {' '.join(parts)}]"
        lines = ["return [dict create"]
        for part in parts:  # broken between fields only
            fits = len(lines[-1]) + len(part) < WIDTH - 14
            lines = [*lines[:-1], f"{lines[-1]} {part}"] if fits else [*lines[:-1], f"{lines[-1]} \\", f"    {part}"]
        return "\n".join(lines) + "]"


def _wrapped(line: str, indent: str = "    ") -> list[str]:
    """A command over several lines, each but the last with a backslash."""
    lines = textwrap.wrap(line, WIDTH - 12, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)
    return [f"{each} \\" for each in lines[:-1]] + lines[-1:]


def _write_count(f: Field) -> list[str]:
    return [f"append out [count {f.name} {_size(f)} {f.max}]"]


def _size(f: Field) -> str:
    return f"[string length [dict get $value {f.name}]]" if f.is_raw else f"[llength [dict get $value {f.name}]]"


def _write(interface: Interface, f: Field) -> list[str]:
    lines = _write_count(f) if f.has_count else []
    value = f"[dict get $value {f.name}]"
    if f.is_raw:
        return lines + [f"append out [pad {f.name} {value}{f' {f.length}' if f.length is not None else ''}]"]
    if not f.is_array:
        one = f"[put {f.type} {value}]" if f.is_scalar else f"[{_command(interface, f, 'write')} {value}]"
        return [f"append out {one}"]
    if f.length is not None:
        lines.append(f"exactly {f.name} {_size(f)} {f.length}")
    if f.is_scalar:
        return lines + [f"append out [put_list {f.type} {value}]"]
    return lines + [f"foreach item {value} {{append out [{_command(interface, f, 'write')} $item]}}"]
