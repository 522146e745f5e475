"""playhouse/wire/generated/fields.h: every struct field by field, so that tests can fill any value at random."""

from __future__ import annotations

from codegen.emit_cpp import FOLDER, banner, namespace
from codegen.model import COMMON, Field, Interface, Message, Schema, Struct

ABOUT = """#pragma once

/// Every struct as a list of fields, and every message as a type. For tests that fill values at random and check
/// properties of all messages. each_field(m, f) calls f.field(member), f.list(member, max) for counted and dynamic
/// arrays, f.fixed_text(member, length) for text of fixed length. each_message(f) calls f.operator()<Payload>(name).
"""


def emit(schema: Schema) -> dict[str, str]:
    lines = [banner("interfaces/").rstrip(), ABOUT]
    lines += [f'#include "{FOLDER}/{i.name}.h"' for i in schema.all()]
    for interface in schema.all():
        lines += ["", f"namespace {namespace(interface)} {{"]
        for struct in interface.structs:
            lines += ["", *_struct(struct)]
        lines += ["", f"}}  // namespace {namespace(interface)}"]
    lines += ["", "namespace playhouse::wire {", "", "template <typename F>", "void each_message(F& f) {"]
    lines += [_call(i, m) for i in schema.all() for m in i.messages if m.payload]
    return {f"{FOLDER}/fields.h": "\n".join([*lines, "}", "", "}  // namespace playhouse::wire", ""])}


def _struct(struct: Struct) -> list[str]:
    return ["template <typename F>", f"void each_field({struct.name}& m, F& f) {{", *map(_visit, struct.fields), "}"]


def _visit(f: Field) -> str:
    if f.has_count:
        return f"  f.list(m.{f.name}, {f.max});"
    if f.is_text:
        return f"  f.fixed_text(m.{f.name}, {f.length});"
    return f"  f.field(m.{f.name});"


def _call(interface: Interface, m: Message) -> str:
    label = "universal" if interface.name == COMMON else interface.name
    payload = m.payload if m.owner == COMMON else f"{m.owner}::{m.payload}"
    return f'  f.template operator()<{payload}>("{label}.{m.label}");'
