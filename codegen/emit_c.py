"""Writes the codecs of the client library in C: clients/c/include/playhouse/c/generated/ and clients/c/src/generated/.

A header per interface has its constants, a struct per struct with its codec (PH_CODEC of playhouse/c/wire.h), and a
macro per message, with Player's name and another prefix (PLAYER_POSITION2D_CMD_VEL is PH_POSITION2D_CMD_VEL). A source
per interface has the tables that encode and decode them; catalogue.c joins those of the messages.
"""

from __future__ import annotations

import re
import textwrap

from codegen.checks import SchemaError
from codegen.model import COMMON, Constants, Field, Interface, Message, Schema, Struct

FOLDER = "clients/c/include/playhouse/c/generated"
SOURCES = "clients/c/src/generated"
WIDTH = 110
SCALAR_TYPES = {
    "char": "char", "int8": "int8_t", "uint8": "uint8_t", "int16": "int16_t", "uint16": "uint16_t", "int32": "int32_t",
    "uint32": "uint32_t", "int64": "int64_t", "float32": "float", "float64": "double",
}

# Words that name no field in C or C++, of those that a definition may have.
KEYWORDS = set("""
    alignas alignof and asm auto bool break case catch char class const constexpr continue default delete do double else
    enum explicit export extern false float for friend goto if inline int long mutable namespace new not operator or
    private protected public register restrict return short signed sizeof static struct switch template this throw true
    try typedef typename union unsigned using virtual void volatile while xor
""".split())


def emit(schema: Schema) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    _check_names(schema)
    files = {}
    for interface in schema.all():
        files[f"{FOLDER}/{interface.name}.h"] = _header(interface)
        files[f"{SOURCES}/{interface.name}.c"] = _source(interface)
    files[f"{FOLDER}/all.h"] = _all_headers(schema)
    files[f"{SOURCES}/catalogue.h"] = _catalogue_header(schema)
    files[f"{SOURCES}/catalogue.c"] = _catalogue(schema)
    return files


def _check_names(schema: Schema) -> None:
    """C has one space of names for all interfaces."""
    names = [struct_name(i.name, s.name) for i in schema.all() for s in i.structs]
    names += [_message_name(i, m) for i in schema.all() for m in i.messages]
    names += [_constant_name(i, n) for i in schema.all() for c in i.constants for n in c.values]
    names += [f"PH_{i.name.upper()}_CODE" for i in schema.interfaces]
    for name in names:
        if names.count(name) > 1:
            raise SchemaError(f"interfaces/: {name} would stand for two things in C")
    for i in schema.all():
        for f in [f for s in i.structs for f in s.fields if f.name in KEYWORDS]:
            raise SchemaError(f"{i.source}: {f.name} cannot be a field in C and C++")


def struct_name(interface: str, struct: str) -> str:
    """CmdVel of position2d -> ph_position2d_cmd_vel."""
    return f"ph_{interface}_{re.sub(r'(?<=[a-z0-9])(?=[A-Z])', '_', struct).lower()}"


def _message_name(interface: Interface, m: Message) -> str:
    return f"PH_{interface.name.upper()}_{m.kind}_{m.name}"


def _constant_name(interface: Interface, name: str) -> str:
    return f"PH_{interface.name.upper()}_{name}"


def comment(text: str, indent: str = "") -> list[str]:
    lines = textwrap.wrap(text.strip(), WIDTH - len(indent) - 7)
    if not lines:
        return []
    lines = [f"{indent}/** {lines[0]}", *(f"{indent} * {line}" for line in lines[1:])]
    return [*lines[:-1], lines[-1] + " */"]


# --- headers -------------------------------------------------------------------------------------------------------


def _header(interface: Interface) -> str:
    shared = interface.code is None
    guard = f"PLAYHOUSE_C_GENERATED_{interface.name.upper()}_H"
    title = "What every interface shares." if shared else f"Interface {interface.name}, code {interface.code}."
    lines = comment(f"{title} {interface.doc} Generated from {interface.source} by codegen; do not edit.")
    lines += [f"#ifndef {guard}", f"#define {guard}", ""]
    lines += [f'#include "playhouse/c/generated/{name}.h"' for name in _includes(interface)]
    lines += ['#include "playhouse/c/wire.h"', "", "#ifdef __cplusplus", 'extern "C" {', "#endif", ""]
    if not shared:
        lines += [f"#define PH_{interface.name.upper()}_CODE {interface.code}", ""]
    for group in interface.constants:
        lines += _constants(interface, group)
    for struct in interface.in_order():
        lines += _struct(interface, struct)
    lines += _messages(interface)
    lines += ["", "#ifdef __cplusplus", "}", "#endif", "", f"#endif  /* {guard} */", ""]
    return "\n".join(lines)


def _includes(interface: Interface) -> list[str]:
    """Other interfaces whose structs are used here."""
    owners = {f.owner for s in interface.structs for f in s.fields} | {m.owner for m in interface.messages}
    return sorted(owners - {"", interface.name})


def _constants(interface: Interface, group: Constants) -> list[str]:
    lines = [*comment(group.doc), "enum {"]
    lines += [f"  {_constant_name(interface, name)} = {value}," for name, value in group.values.items()]
    return [*lines, "};", ""]


def _struct(interface: Interface, struct: Struct) -> list[str]:
    name = struct_name(interface.name, struct.name)
    lines = [*comment(f"{struct.doc} ({struct.c_name})"), f"typedef struct {name} {{"]
    for f in struct.fields:
        lines += [*comment(_about(f), "  "), *(f"  {member}" for member in _members(f))]
    return [*lines, f"}} {name};", f"PH_CODEC({name})", ""]


def _about(f: Field) -> str:
    bound = f"At most {f.max}." if f.has_count and not f.dynamic else ""
    return " ".join(part for part in (f.described(), bound) if part)


def _members(f: Field) -> list[str]:
    one = SCALAR_TYPES[f.type] if f.is_scalar else struct_name(f.owner, f.type)
    if f.has_count:
        return [f"const {one} *{f.name};", f"uint32_t {f.count_name};"]
    return [f"{one} {f.name}{f'[{f.length}]' if f.length else ''};"]


def _messages(interface: Interface) -> list[str]:
    rows = f"ph_{interface.name}_messages"
    lines = ["/** The messages, each under its name below. */"]
    lines.append(f"extern const ph_message_type {rows}[{len(interface.messages)}];")
    for at, m in enumerate(interface.sorted_messages()):
        lines += [*comment(m.doc), f"#define {_message_name(interface, m)} (&{rows}[{at}])"]
    return lines


def _all_headers(schema: Schema) -> str:
    guard = "PLAYHOUSE_C_GENERATED_ALL_H"
    lines = comment("Every interface. Generated from interfaces/ by codegen; do not edit.")
    lines += [f"#ifndef {guard}", f"#define {guard}", ""]
    lines += [f'#include "playhouse/c/generated/{name}.h"' for name in sorted(i.name for i in schema.all())]
    return "\n".join([*lines, "", f"#endif  /* {guard} */", ""])


# --- sources -------------------------------------------------------------------------------------------------------


def _source(interface: Interface) -> str:
    lines = [*comment(f"Generated from {interface.source} by codegen; do not edit."),
             f'#include "playhouse/c/generated/{interface.name}.h"', "", "#include <stddef.h>", ""]
    for struct in interface.in_order():
        lines += _tables(interface, struct)
    lines.append(f"const ph_message_type ph_{interface.name}_messages[{len(interface.messages)}] = {{")
    for m in interface.sorted_messages():
        payload = f"&{struct_name(m.owner, m.payload)}_type" if m.payload else "NULL"
        lines.append(f'    {{{interface.code or 0}, PH_KIND_{m.kind}, {m.subtype}, "{interface.full_name(m)}", {payload}}},')
    return "\n".join([*lines, "};", ""])


def _tables(interface: Interface, struct: Struct) -> list[str]:
    name = struct_name(interface.name, struct.name)
    lines = [f"static const ph_field {name}_fields[{len(struct.fields)}] = {{"]
    lines += [f"    {{{', '.join(_field(name, struct, f))}}}," for f in struct.fields]
    row = [f'"{interface.name}.{struct.name}"', f"{name}_fields", str(len(struct.fields)), str(struct.min_bytes),
           f"sizeof({name})"]
    return [*lines, "};", f"const ph_struct_type {name}_type = {{{', '.join(row)}}};", ""]


def _field(name: str, struct: Struct, f: Field) -> list[str]:
    return field_row(name, struct, f, "COUNTED", struct_name(f.owner, f.type))


def field_row(name: str, struct: Struct, f: Field, counted: str, of: str) -> list[str]:
    """The initializer of a ph_field of the C struct `name`, whose bounded lists have the shape `counted`; `of` is the C struct of its value."""
    shape = "DYNAMIC" if f.dynamic else counted if f.has_count else "FIXED" if f.is_array else "ONE"
    early = [at for at, g in enumerate(struct.fields, 1) if g.has_count and g.count_before == f.name]
    if len(early) > 1 or (f.count_before and not f.dynamic):
        raise SchemaError(f"{struct.c_name}: this order of counts is not written in C yet")
    return [
        f'"{f.name}"', f"PH_TYPE_{f.type.upper() if f.is_scalar else 'STRUCT'}", f"PH_SHAPE_{shape}",
        str(early[0] if early else 0), "1" if f.count_before else "0", str(f.length or f.max or 1),
        f"offsetof({name}, {f.name})", f"offsetof({name}, {f.count_name})" if f.has_count else "0",
        "NULL" if f.is_scalar else f"&{of}_type",
    ]


# --- the catalogue -------------------------------------------------------------------------------------------------


def _catalogue_header(schema: Schema) -> str:
    return "\n".join([
        *comment("The interfaces and their messages, by code. Generated from interfaces/ by codegen; do not edit."),
        "#ifndef PLAYHOUSE_C_CATALOGUE_H", "#define PLAYHOUSE_C_CATALOGUE_H", "", '#include "playhouse/c/wire.h"',
        "",
        "typedef struct ph_interface {", "  uint16_t code;", "  uint16_t message_count;", "  const char *name;",
        "  const ph_message_type *messages;", "} ph_interface;", "",
        "/** The shared messages first, with code 0. */", f"enum {{ PH_INTERFACE_COUNT = {len(schema.all())} }};",
        "extern const ph_interface ph_interfaces[PH_INTERFACE_COUNT];", "",
        "#endif  /* PLAYHOUSE_C_CATALOGUE_H */", ""])


def _catalogue(schema: Schema) -> str:
    lines = [*comment("Generated from interfaces/ by codegen; do not edit."), '#include "catalogue.h"', "",
             '#include "playhouse/c/generated/all.h"', "", "const ph_interface ph_interfaces[PH_INTERFACE_COUNT] = {"]
    for i in schema.all():
        name = "universal" if i.name == COMMON else i.name
        lines.append(f'    {{{i.code or 0}, {len(i.messages)}, "{name}", ph_{i.name}_messages}},')
    return "\n".join([*lines, "};", ""])
