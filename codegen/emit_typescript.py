"""Writes clients/typescript/src/generated/: one module per interface, and index.ts.

A module has the interface's constants, for each struct an interface and the codec of the same name, and one MessageType per
message, with Player's name without the prefix (PLAYER_POSITION2D_CMD_VEL is position2d.CMD_VEL). Fields are in camelCase.
"""

from __future__ import annotations

import textwrap

from codegen.checks import SchemaError
from codegen.model import COMMON, OPAQUE, SCALARS, Constants, Field, Interface, Message, Schema, Struct

FOLDER = "clients/typescript/src/generated"
WIDTH = 120

# Lists of these are decoded in bulk.
TYPED_ARRAYS = {"float32": "Float32Array", "float64": "Float64Array"}
# Words that cannot name a local variable of a module, and `from`, which reads them.
RESERVED = set("""arguments await break case catch class const continue debugger default delete do else enum eval export extends false
finally for function if implements import in instanceof interface let new null package private protected public return static super
switch this throw true try typeof var void while with yield from""".split())


def emit(schema: Schema) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files = {f"{FOLDER}/{i.name}.ts": _module(schema, i) for i in schema.all()}
    files[f"{FOLDER}/index.ts"] = _index(schema)
    return files


def _module(schema: Schema, interface: Interface) -> str:
    _check_names(interface)
    shared = interface.code is None
    title = "What every interface shares" if shared else f"Interface {interface.name}, code {interface.code}"
    about = f"Generated from {interface.source} by codegen; do not edit."
    parts = [_comment([*_wrapped(f"{title}. {interface.doc}", 0), "", about], 0) + "\n", _imports(interface)]
    if not shared:
        parts.append(f"export const CODE = {interface.code};\n")
    parts += [_constants(interface, c) for c in interface.constants]
    parts += [_struct(schema, interface, s) for s in interface.structs]
    parts += [_message(interface, m) for m in interface.messages]
    return "\n".join(parts)


def _check_names(interface: Interface) -> None:
    names = [s.name for s in interface.structs] + [m.constant for m in interface.messages]
    names += [interface.constant(n) for c in interface.constants for n in c.values]
    for name in names:
        if names.count(name) > 1 or name in ("CODE", "Codec", "Kind", "MessageType"):
            raise SchemaError(f"{interface.source}: {name} would stand for two things in TypeScript")
    for s in interface.structs:
        fields = [_name(f) for f in s.fields]
        for name in fields:
            if name in RESERVED or fields.count(name) > 1:
                raise SchemaError(f"{interface.source}: {s.name}.{name} cannot be a field in TypeScript")


def _imports(interface: Interface) -> str:
    names = (["Codec"] if interface.structs else []) + (["Kind", "MessageType"] if interface.messages else [])
    owners = {f.owner for s in interface.structs for f in s.fields} | {m.owner for m in interface.messages}
    lines = [f"import {{ {', '.join(names)} }} from '../wire.js';"]
    lines += [f"import * as {owner} from './{owner}.js';" for owner in sorted(owners - {"", interface.name})]
    return "\n".join(lines) + "\n"


def _constants(interface: Interface, constants: Constants) -> str:
    lines = [f"// {line}" for line in textwrap.wrap(constants.doc, WIDTH - 3)]
    lines += [f"export const {interface.constant(name)} = {value};" for name, value in constants.values.items()]
    return "\n".join(lines) + "\n"


def _name(f: Field) -> str:
    first, *rest = f.name.split("_")
    return first + "".join(part[:1].upper() + part[1:] for part in rest)


def _struct(schema: Schema, interface: Interface, s: Struct) -> str:
    lines = [_comment(_wrapped(f"{s.doc} ({s.c_name})", 0), 0), f"export interface {s.name} {{"]
    for f in s.fields:
        about = textwrap.wrap(f.described(), WIDTH - 6)
        lines += [_comment(about, 2)] if about else []
        lines.append(f"  {_name(f)}: {_type(interface, f)};")
    lines += ["}", "", f"export const {s.name}: Codec<{s.name}> = new Codec<{s.name}>('{interface.name}.{s.name}', {{"]
    lines += _call("  zero: () => ({ ", [f"{_name(f)}: {_zero(interface, f)}" for f in s.fields], " }),", "  zero: () => ({", "  }),")
    lines.append("  write(to, value) {" if s.fields else "  write() {")
    for step, f in s.steps():
        lines += ["    " + line for line in (_write_count(f) if step == "count" else _write(interface, f))]
    lines += ["  },", "  read(from) {" if s.fields else "  read() {"]
    for step, f in s.steps():
        lines += ["    " + line for line in (_read_count(f) if step == "count" else _read(schema, interface, f))]
    lines += _call("    return { ", [_name(f) for f in s.fields], " };", "    return {", "    };")
    return "\n".join(lines + ["  },", "});", ""])


def _call(start: str, parts: list[str], end: str, first: str, last: str) -> list[str]:
    """The parts on one line, or if that is too long, one below the other."""
    line = start + ", ".join(parts) + end
    if len(line) <= WIDTH:
        return [line]
    indent = " " * (len(first) - len(first.lstrip()) + 2)
    return [first, *(f"{indent}{part}," for part in parts), last]


def _codec(interface: Interface, f: Field) -> str:
    return f.type if f.owner == interface.name else f"{f.owner}.{f.type}"


def _method(f: Field) -> str:
    """Name of the function of Reader and Writer for one number."""
    return "int8" if f.type == "char" else f.type


def _type(interface: Interface, f: Field) -> str:
    if f.is_raw:
        return "Uint8Array"
    if f.is_array and f.type in TYPED_ARRAYS:
        return TYPED_ARRAYS[f.type]
    one = ("bigint" if f.type == "int64" else "number") if f.is_scalar else _codec(interface, f)
    return f"{one}[]" if f.is_array else one


def _zero(interface: Interface, f: Field) -> str:
    if f.is_raw:
        return "new Uint8Array()"
    if f.is_array and f.type in TYPED_ARRAYS:
        return f"new {TYPED_ARRAYS[f.type]}({f.length or ''})"
    if f.is_array and f.length is None:
        return "[]"
    one = ("0n" if f.type == "int64" else "0") if f.is_scalar else f"{_codec(interface, f)}.make()"
    return f"Array.from({{ length: {f.length} }}, () => {one})" if f.is_array else one


def _write_count(f: Field) -> list[str]:
    return [f"to.length('{f.name}', value.{_name(f)}.length, {f.max});"]


def _write(interface: Interface, f: Field) -> list[str]:
    me = f"value.{_name(f)}"
    lines = _write_count(f) if f.has_count else []
    if f.is_raw:
        return [f"to.fixed('{f.name}', {me}, {f.length});"] if f.length is not None else [*lines, f"to.opaque({me});"]
    if not f.is_array:
        return [f"to.{_method(f)}({me});" if f.is_scalar else f"{_codec(interface, f)}.write(to, {me});"]
    if f.length is not None:
        lines.append(f"to.exactly('{f.name}', {me}.length, {f.length});")
    if f.type in TYPED_ARRAYS:
        return [*lines, f"to.{f.type}s({me});"]
    one = f"to.{_method(f)}(each)" if f.is_scalar else f"{_codec(interface, f)}.write(to, each)"
    return [*lines, f"for (const each of {me}) {one};"]


def _read_count(f: Field) -> list[str]:
    return [f"const {_name(f)}Count = from.uint32();" if f.dynamic else "from.uint32();"]


def _read(schema: Schema, interface: Interface, f: Field) -> list[str]:
    me = f"const {_name(f)}"
    one = f"from.{_method(f)}()" if f.is_scalar else f"{_codec(interface, f)}.read(from)"
    if not f.is_array:
        return [f"{me} = {one};"]
    length = str(f.length)
    if f.length is None:
        least = 1 if f.type in OPAQUE else SCALARS[f.type] if f.is_scalar else schema.struct_of(f).min_bytes
        length = f"from.length('{f.name}', {f'{_name(f)}Count' if f.dynamic else f.max}, {least})"
    if f.is_raw:
        return [f"{me} = from.opaque({length});"]
    if f.type in TYPED_ARRAYS:
        return [f"{me} = from.{f.type}s({length});"]
    return [f"{me} = from.many({length}, () => {one});"]


def _message(interface: Interface, m: Message) -> str:
    payload = m.payload if m.owner == interface.name else f"{m.owner}.{m.payload}"
    name = interface.full_name(m)
    row = [str(interface.code or 0), f"Kind.{m.kind}", str(m.subtype), f"'{name}'"] + ([payload] if m.payload else [])
    kind = payload if m.payload else "undefined"
    made = _call(f"export const {m.constant}: MessageType<{kind}> = new MessageType(", row, ");",
                 f"export const {m.constant}: MessageType<{kind}> = new MessageType(", ");")
    return "\n".join(([_comment(_wrapped(m.doc, 0), 0)] if m.doc else []) + made) + "\n"


def _index(schema: Schema) -> str:
    about = ["Every interface of the Player protocol: values, and their encoding and decoding.", "",
             "Generated from interfaces/ by codegen; do not edit."]
    names = [i.name for i in schema.interfaces]
    lines = [_comment(about, 0), "", "import { Kind, MessageType, type AnyMessage } from '../wire.js';"]
    lines += [f"import * as {name} from './{name}.js';" for name in [COMMON, *names]]
    lines += ["", *_call("export { ", [COMMON, *names], " };", "export {", "};"), ""]
    lines += ["/** Code of an interface -> its name. */", "export const INTERFACES: ReadonlyMap<number, string> = new Map(["]
    lines += [f"  [{i.code}, '{i.name}']," for i in schema.interfaces]
    lines += ["]);", "", "const kCatalogue = new Map<number, AnyMessage>();", "",
              *_call("for (const module of [", [COMMON, *names], "]) {", "for (const module of [", "]) {"),
              "  for (const row of Object.values(module)) {",
              "    if (row instanceof MessageType) kCatalogue.set(keyOf(row.interface, row.kind, row.subtype), row);", "  }", "}", "",
              "function keyOf(code: number, kind: number, subtype: number): number {",
              "  return (code * 256 + kind) * 256 + subtype;", "}", ""]
    found = "The row of a message, or undefined. Answers have the row of their request; shared messages apply to every interface."
    lines += [_comment(_wrapped(found, 0), 0),
              "export function findMessage(code: number, kind: number, subtype: number): AnyMessage | undefined {",
              "  const row = kind === Kind.ACK || kind === Kind.NACK ? Kind.REQ : kind;",
              "  return kCatalogue.get(keyOf(0, row, subtype)) ?? kCatalogue.get(keyOf(code, row, subtype));", "}", ""]
    return "\n".join(lines)


def _wrapped(text: str, indent: int) -> list[str]:
    return textwrap.wrap(text.strip(), WIDTH - indent - 7)


def _comment(lines: list[str], indent: int) -> str:
    space = " " * indent
    if len(lines) == 1:
        return f"{space}/** {lines[0]} */"
    return "\n".join([f"{space}/**", *(f"{space} * {line}".rstrip() for line in lines), f"{space} */"])
