"""Writes what old C programs know of the messages, by its old names: clients/c/playerc/generated/.

libplayerinterface/player_interfaces.h has the constants, the numbers of the messages and the structs (player_laser_data_t)
of all interfaces. player_types.c has the tables by which the C client library encodes and decodes those structs
(ph_struct_type of playhouse/c/wire.h), and the functions that copy and release them.
"""

from __future__ import annotations

from codegen.emit_c import SCALAR_TYPES, comment, field_row
from codegen.model import COMMON, KINDS, Constants, Field, Interface, Message, Schema, Struct

FOLDER = "clients/c/playerc/generated"
HEADER = f"{FOLDER}/include/libplayerinterface/player_interfaces.h"
TYPES = f"{FOLDER}/src/player_types.h"
SOURCE = f"{FOLDER}/src/player_types.c"
MADE = "Generated from interfaces/ by codegen; do not edit."


def emit(schema: Schema) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {HEADER: _header(schema), TYPES: _types_header(schema), SOURCE: _source(schema)}


def _in_order(schema: Schema) -> list[Interface]:
    """The interfaces, each after those whose structs it uses."""
    done: list[Interface] = []

    def add(interface: Interface) -> None:
        if interface in done:
            return
        for name in interface.needs():
            add(schema.interface(name))
        done.append(interface)

    for interface in schema.all():
        add(interface)
    return done


def _structs(schema: Schema) -> list[Struct]:
    return [struct for interface in _in_order(schema) for struct in interface.in_order()]


# --- the header ----------------------------------------------------------------------------------------------------


def _header(schema: Schema) -> str:
    guard = "LIBPLAYERINTERFACE_PLAYER_INTERFACES_H"
    lines = [*comment(f"The messages of all interfaces by the names of Player 3. {MADE}"), f"#ifndef {guard}", f"#define {guard}", "",
             "#include <stdint.h>", "", "#ifdef __cplusplus", 'extern "C" {', "#endif", "",
             *comment("Of each struct T below: T_copy() makes `to` a copy of `from` with lists of its own and returns the size of T, 0 without memory; T_cleanup() releases "
                      "the lists of a value; T_clone() makes a copy of a value, NULL without memory, and T_free() releases it."),
             "#define PLAYER_STRUCT(T)                     \\", "  unsigned int T##_copy(T *to, const T *from); \\",
             "  void T##_cleanup(const T *value);            \\", "  T *T##_clone(const T *value);                \\", "  void T##_free(T *value);", ""]
    for interface in _in_order(schema):
        lines += _interface(schema, interface)
    lines += ["#undef PLAYER_STRUCT", "", "#ifdef __cplusplus", "}", "#endif", "", f"#endif /* {guard} */", ""]
    return "\n".join(lines)


def _interface(schema: Schema, interface: Interface) -> list[str]:
    lines = [f"/* --- {interface.name} */", ""]
    if interface.name != COMMON:
        lines += [*comment(interface.doc), f"#define PLAYER_{interface.name.upper()}_CODE {interface.code}",
                  f'#define PLAYER_{interface.name.upper()}_STRING "{interface.name}"', ""]
    for group in interface.constants:
        lines += _constants(group)
    for message in interface.sorted_messages():
        lines += [*comment(message.doc), f"#define {_message_name(interface, message)} {message.subtype}"]
    lines.append("")
    for struct in interface.in_order():
        lines += _struct(schema, struct)
    return lines


def _message_name(interface: Interface, message: Message) -> str:
    """PLAYER_LASER_REQ_GET_GEOM; PLAYER_CAPABILITIES_REQ of those that are for every interface."""
    return f"PLAYER_{message.name}_{message.kind}" if interface.name == COMMON else f"PLAYER_{interface.name.upper()}_{message.kind}_{message.name}"


def _constants(group: Constants) -> list[str]:
    return [*comment(group.doc), *(f"#define {group.c_prefix}{name} {value}" for name, value in group.values.items()), ""]


def _struct(schema: Schema, struct: Struct) -> list[str]:
    lines = [*comment(struct.doc), f"typedef struct {struct.c_name.removesuffix('_t')} {{"]
    for step, f in struct.steps():
        if step == "count":
            lines.append(f"  uint32_t {f.count_name};")
        else:
            lines += [*comment(f.described(), "  "), f"  {_member(schema, f)};"]
    return [*lines, f"}} {struct.c_name};", f"PLAYER_STRUCT({struct.c_name})", ""]


def _member(schema: Schema, f: Field) -> str:
    one = SCALAR_TYPES[f.original_type] if f.is_scalar else schema.struct_of(f).c_name
    if f.dynamic:
        return f"{one} *{f.name}"
    return f"{one} {f.name}{f'[{f.length or f.max}]' if f.is_array else ''}"


# --- the tables ----------------------------------------------------------------------------------------------------


def _types_header(schema: Schema) -> str:
    guard = "LIBPLAYERC_PLAYER_TYPES_H"
    rows = sum(len(i.messages) for i in schema.all())
    lines = [*comment(f"The tables of the structs of player_interfaces.h. {MADE}"), f"#ifndef {guard}", f"#define {guard}", "",
             '#include "playhouse/c/wire.h"', "",
             *comment("Every message with the struct of its body, by interface, kind and subtype; code 0 has those that are for every interface."),
             f"enum {{ PLAYER_MESSAGE_COUNT = {rows} }};", "extern const ph_message_type player_messages[PLAYER_MESSAGE_COUNT];", "",
             *(f"extern const ph_struct_type {struct.c_name}_type;" for struct in _structs(schema))]
    return "\n".join([*lines, "", f"#endif /* {guard} */", ""])


def _source(schema: Schema) -> str:
    lines = [*comment(MADE), '#include "player_types.h"', "", "#include <stddef.h>", "", '#include "libplayerinterface/player_interfaces.h"',
             '#include "values.h"', ""]
    for struct in _structs(schema):
        lines += _tables(schema, struct)
    lines.append("const ph_message_type player_messages[PLAYER_MESSAGE_COUNT] = {")
    for interface in schema.all():
        for m in sorted(interface.messages, key=lambda m: (KINDS[m.kind], m.subtype)):
            body = schema.interface(m.owner).struct(m.payload) if m.payload else None
            of = f"&{body.c_name}_type" if body else "NULL"
            lines.append(f'    {{{interface.code or 0}, PH_KIND_{m.kind}, {m.subtype}, "{interface.full_name(m)}", {of}}},')
    return "\n".join([*lines, "};", ""])


def _tables(schema: Schema, struct: Struct) -> list[str]:
    name = struct.c_name
    lines = [f"static const ph_field {name}_fields[{len(struct.fields)}] = {{"]
    for f in struct.fields:
        of = "" if f.is_scalar else schema.struct_of(f).c_name
        lines.append(f"    {{{', '.join(field_row(name, struct, f, 'INLINE', of))}}},")
    row = [f'"{name}"', f"{name}_fields", str(len(struct.fields)), str(struct.min_bytes), f"sizeof({name})"]
    return [*lines, "};", f"const ph_struct_type {name}_type = {{{', '.join(row)}}};", f"PLAYER_STRUCT_FUNCTIONS({name})", ""]
