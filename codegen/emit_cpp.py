"""C++ values with encode, decode and JSON: playhouse/wire/generated/.

One header and one source per interface, and rows.h / catalogue.cc, which join them for playhouse/wire/messages.h.
"""

from __future__ import annotations

import textwrap

from codegen.model import COMMON, OPAQUE, SCALARS, Field, Interface, Message, Schema, Struct

FOLDER = "playhouse/wire/generated"
WIDTH = 110
SCALAR_TYPES = {
    "char": "char", "int8": "std::int8_t", "uint8": "std::uint8_t", "int16": "std::int16_t",
    "uint16": "std::uint16_t", "int32": "std::int32_t", "uint32": "std::uint32_t", "int64": "std::int64_t",
    "float32": "float", "float64": "double",
}


def emit(schema: Schema) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    files = {}
    for interface in schema.all():
        files[f"{FOLDER}/{interface.name}.h"] = _header(interface)
        files[f"{FOLDER}/{interface.name}.cc"] = _source(schema, interface)
    files[f"{FOLDER}/rows.h"] = _rows_header(schema)
    files[f"{FOLDER}/catalogue.cc"] = catalogue(schema)
    return files


def banner(source: str) -> str:
    return f"// Generated from {source} by codegen (python3 -m codegen). Do not edit.\n"


def namespace(interface: Interface) -> str:
    return "playhouse::wire" if interface.name == COMMON else f"playhouse::wire::{interface.name}"


def constant_name(name: str) -> str:
    """STATE_OPEN -> kStateOpen, FREQ_44k -> kFreq44k."""
    return "k" + "".join(p[:1].upper() + p[1:].lower() for p in name.split("_"))


def cpp_type(f: Field, inside: str) -> str:
    """The type of a member; `inside` is the interface of the enclosing namespace."""
    one = SCALAR_TYPES.get(f.type) or (f.type if f.owner in (COMMON, inside) else f"{f.owner}::{f.type}")
    if f.is_text:
        return "std::string"
    if f.length is not None:
        return f"std::array<{one}, {f.length}>"
    return f"std::vector<{one}>" if f.is_array else one


def _comment(text: str, indent: str = "") -> list[str]:
    return textwrap.wrap(text, WIDTH, initial_indent=f"{indent}/// ", subsequent_indent=f"{indent}/// ")


# --- headers -------------------------------------------------------------------------------------------------------


def _header(interface: Interface) -> str:
    shared = interface.name == COMMON
    own = ["playhouse/wire/codec.h"] if shared else []
    own += [f"{FOLDER}/{name}.h" for name in sorted([*interface.needs(), *([] if shared else [COMMON])])]
    lines = [banner(interface.source).rstrip(), "#pragma once", ""]
    lines += _comment(interface.doc) + ["", *_std_includes(interface), ""]
    lines += [f'#include "{path}"' for path in own]
    lines += ["", f"namespace {namespace(interface)} {{", ""]
    if interface.code is not None:
        lines += [f"inline constexpr std::uint16_t kCode = {interface.code};", ""]
    lines += _subtypes(interface)
    for group in interface.constants:
        lines += _comment(group.doc)
        for name, value in group.values.items():
            lines.append(f"inline constexpr std::int32_t {constant_name(name)} = {value};")
        lines.append("")
    for struct in interface.in_order():
        lines += _struct(struct, interface)
    for struct in interface.structs:
        lines += [f"void read(Reader& in, {struct.name}& m);", f"void write(Writer& out, const {struct.name}& m);",
                  f"void to_json(std::string& out, const {struct.name}& m);"]
    lines += ["", f"}}  // namespace {namespace(interface)}", ""]
    return "\n".join(lines)


def _std_includes(interface: Interface) -> list[str]:
    types = [cpp_type(f, interface.name) for s in interface.structs for f in s.fields]
    names = ["cstdint", "string"]
    names += [n for n in ("array", "vector") if any(t.startswith(f"std::{n}") for t in types)]
    return [f"#include <{n}>" for n in sorted(names)]


def _subtypes(interface: Interface) -> list[str]:
    lines = ["// Subtypes of messages."]
    for m in interface.sorted_messages():
        lines += _comment(m.doc)
        lines.append(f"inline constexpr std::uint8_t {constant_name(m.kind + '_' + m.name)} = {m.subtype};")
    return [*lines, ""]


def _struct(struct: Struct, interface: Interface) -> list[str]:
    lines = _comment(struct.doc) + [f"struct {struct.name} {{"]
    for f in struct.fields:
        about = f.doc
        if f.unit or f.frame:
            quantity = ", ".join(x for x in (f"frame {f.frame}" if f.frame else "", f.unit) if x)
            about = f"{about} [{quantity}]".strip()
        if f.length is not None and f.is_text:
            about = f"{about} ({f.length} bytes; zeros fill a shorter text)".strip()
        elif f.is_array and not f.dynamic and f.length is None:
            about = f"{about} (at most {f.max})".strip()
        lines += _comment(about, "  ") if about else []
        lines.append(f"  {cpp_type(f, interface.name)} {f.name}{initial(f)};")
    lines += ["", f"  friend bool operator==(const {struct.name}&, const {struct.name}&) = default;", "};", ""]
    return lines


def initial(f: Field) -> str:
    return " = 0" if f.is_scalar and not f.is_array else "{}"


# --- sources -------------------------------------------------------------------------------------------------------


def _source(schema: Schema, interface: Interface) -> str:
    lines = [banner(interface.source).rstrip(), f'#include "{FOLDER}/{interface.name}.h"', "",
             f'#include "{FOLDER}/rows.h"', '#include "playhouse/wire/body.h"', '#include "playhouse/wire/json.h"', "",
             f"namespace {namespace(interface)} {{", ""]
    for struct in interface.structs:
        lines += [*_read(schema, struct), "", *_write(struct), "", *_to_json(struct), ""]
    lines += _rows(interface)
    lines += ["", f"}}  // namespace {namespace(interface)}", ""]
    return "\n".join(lines)


def _read(schema: Schema, struct: Struct) -> list[str]:
    lines = [f"void read(Reader& in, {struct.name}& m) {{"]
    for step, f in struct.steps():
        if step == "count":
            lines += [f"  std::uint32_t {f.count_name} = 0;", f"  in.read({f.count_name});"]
        elif not f.is_array:
            lines.append(f"  in.read(m.{f.name});" if f.is_scalar else f"  read(in, m.{f.name});")
        elif f.is_text or f.is_bytes:
            lines.append(f"  in.read_bytes(m.{f.name}, {_length(schema, f)});")
        elif f.has_count and f.is_scalar:
            lines.append(f"  in.read_numbers(m.{f.name}, {_length(schema, f)});")
        else:
            if f.has_count:
                lines.append(f"  m.{f.name}.resize({_length(schema, f)});")
            lines.append(f"  for (auto& element : m.{f.name}) {'in.read(element)' if f.is_scalar else 'read(in, element)'};")
    return [*lines, "}"]


def _length(schema: Schema, f: Field) -> str:
    if f.length is not None:
        return str(f.length)
    one = 1 if f.type in OPAQUE else SCALARS.get(f.type) or schema.struct_of(f).min_bytes
    if f.dynamic:
        return f'in.dynamic_length("{f.name}", {f.count_name}, {one})'
    return f'in.counted_length("{f.name}", {f.max}, {one})'


def _write(struct: Struct) -> list[str]:
    lines = [f"void write(Writer& out, const {struct.name}& m) {{"]
    for step, f in struct.steps():
        length = f'  out.write_length("{f.name}", m.{f.name}.size(), {f.max});'
        if step == "count":
            lines.append(length)
            continue
        if f.has_count:
            lines.append(length)
        if not f.is_array:
            lines.append(f"  out.write(m.{f.name});" if f.is_scalar else f"  write(out, m.{f.name});")
        elif f.length is not None and f.is_text:
            lines.append(f'  out.write_fixed_text("{f.name}", m.{f.name}, {f.length});')
        elif f.is_text or f.is_bytes:
            lines.append(f"  out.write_bytes(std::as_bytes(std::span(m.{f.name})));")
        elif f.has_count and f.is_scalar:
            lines.append(f"  out.write_numbers(m.{f.name});")
        else:
            lines.append(f"  for (const auto& element : m.{f.name}) {'out.write(element)' if f.is_scalar else 'write(out, element)'};")
    return [*lines, "}"]


def _to_json(struct: Struct) -> list[str]:
    lines = [f"void to_json(std::string& out, const {struct.name}& m) {{"]
    opener = "{"
    for f in struct.fields:
        lines.append(f"  json_key(out, '{opener}', \"{f.name}\");")
        opener = ","
        if f.is_text:
            lines.append(f"  json_text(out, m.{f.name});")
        elif f.is_bytes:
            lines.append(f"  json_bytes(out, m.{f.name});")
        elif f.is_array:
            call = "json_value" if f.is_scalar else "to_json"
            lines.append(f"  json_array(out, m.{f.name}, [](std::string& to, const auto& e) {{ {call}(to, e); }});")
        else:
            lines.append(f"  {'json_value' if f.is_scalar else 'to_json'}(out, m.{f.name});")
    return [*lines, "  out += '}';", "}"]


# --- the catalogue -------------------------------------------------------------------------------------------------


def _rows(interface: Interface) -> list[str]:
    label = "universal" if interface.name == COMMON else interface.name
    lines = [f"const MessageDef kRows[{len(interface.messages)}] = {{"]
    for m in interface.sorted_messages():
        kind = f"MessageType::k{m.kind.title()}"
        policy = f"Policy::k{(m.policy or 'none').title()}"
        payload = _payload(m, interface)
        functions = "check_nothing, reencode_nothing, nothing_to_json"
        if payload:
            need = "required" if m.kind in ("DATA", "CMD") else "optional"
            functions = f"check_{need}<{payload}>, reencode<{payload}>, body_to_json<{payload}>"
        shown = payload if interface.name == COMMON or "::" in payload or m.owner == COMMON else f"{interface.name}::{payload}"
        constant = constant_name(m.kind + "_" + m.name)
        lines.append(f'    {{{interface.code or 0}, {kind}, {constant}, "{label}.{m.label}", "{shown if payload else ""}", '
                     f"{'true' if payload else 'false'}, {policy},")
        lines.append(f"     {functions}}},")
    return [*lines, "};"]


def _payload(m: Message, interface: Interface) -> str:
    if not m.payload or m.owner in (COMMON, interface.name):
        return m.payload
    return f"{m.owner}::{m.payload}"


def _rows_header(schema: Schema) -> str:
    lines = [banner("interfaces/").rstrip(), "#pragma once", "",
             "/// The rows of the catalogue, one table per interface, by (type, subtype). For generated/*.cc only.", "",
             '#include "playhouse/wire/messages.h"', "", "namespace playhouse::wire {", "",
             f"extern const MessageDef kRows[{len(schema.common.messages)}];"]
    for i in schema.interfaces:
        lines += [f"namespace {i.name} {{", f"extern const MessageDef kRows[{len(i.messages)}];", "}"]
    return "\n".join([*lines, "", "}  // namespace playhouse::wire", ""])


def catalogue(schema: Schema) -> str:
    """catalogue.cc, of the interfaces of the schema."""
    lines = [banner("interfaces/").rstrip(), f'#include "{FOLDER}/rows.h"', "", "namespace playhouse::wire {", "",
             "namespace {", "", f"constexpr InterfaceDef kInterfaces[{len(schema.interfaces)}] = {{"]
    lines += [f'    {{{i.code}, "{i.name}", {i.name}::kRows}},' for i in schema.interfaces]
    lines += ["};", "", "}  // namespace", "", "std::span<const InterfaceDef> interfaces() { return kInterfaces; }", "",
              "std::span<const MessageDef> universal_messages() { return kRows; }", "", "}  // namespace playhouse::wire", ""]
    return "\n".join(lines)
