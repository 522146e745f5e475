"""playhouse/drivers/generated/wire_fields.cc: what the definitions say of every field, for drivers that make values of any payload."""

from __future__ import annotations

import re

from codegen.checks import SchemaError
from codegen.emit_cpp import banner
from codegen.model import COMMON, SCALARS, Field, Interface, Schema, Struct, parts_of

PATH = "playhouse/drivers/generated/wire_fields.cc"

# The doc of a group of constants that are all values of a field: "Values of Data.mode and Link.mode.", "Bits of
# Data.valid: valid fields." ", by number" follows where a constant is the number of a bit.
CHOICES = re.compile(r"(Values|Bits) of ([\w.]+(?: and [\w.]+)*)(, by number)?(?:: .*)?\.$")
QUESTION = "Requests "  # how the doc of a request begins that asks for its payload and sets nothing


def emit(schema: Schema) -> dict[str, str]:
    structs = [(i, s) for i in schema.all() for s in i.structs]
    rows = {(i.name, s.name): row for row, (i, s) in enumerate(structs)}
    lines = [banner("interfaces/").rstrip(), '#include "playhouse/drivers/dummy/wire_fields.h"', "", "namespace playhouse::drivers {",
             "namespace wire_tables {", "", "using enum FieldType;", "using enum FieldShape;", ""]
    lists = []
    for row, (interface, struct) in enumerate(structs):
        choices = choices_of(interface)
        lines.append(f"constexpr WireField kFields{row}[] = {{  // {_full_name(interface, struct)}")
        lines += [_field(schema, rows, step, f, choices.get(f"{struct.name}.{f.name}"), lists) for step, f in struct.steps()]
        lines.append("};")
    lines += ["", "constexpr WireStruct kStructs[] = {"]
    lines += [f'    {{"{_full_name(i, s)}", kFields{row}}},' for row, (i, s) in enumerate(structs)]
    lines += ["};", "", "constexpr WireQuestion kQuestions[] = {"]
    lines += [f"    {{{i.code}, {m.subtype}}},  // {i.full_name(m)}" for i in schema.interfaces for m in i.sorted_messages()
              if m.kind == "REQ" and m.doc.startswith(QUESTION)]
    lines += ["};", "", "}  // namespace wire_tables", "",
              "std::span<const WireStruct> wire_structs() { return wire_tables::kStructs; }",
              "std::span<const WireQuestion> wire_questions() { return wire_tables::kQuestions; }", "", "}  // namespace playhouse::drivers", ""]
    at = lines.index("using enum FieldShape;") + 2
    lines[at:at] = [*lists, ""]
    return {PATH: "\n".join(lines)}


def choices_of(interface: Interface) -> dict[str, list[int]]:
    """"Data.mode" -> its values, in their order; all bits of a field are one value."""
    found: dict[str, list[int]] = {}
    known = {f"{s.name}.{f.name}" for s in interface.structs for f in s.fields}
    for group in interface.constants:
        told = CHOICES.match(group.doc)
        if not told:
            continue
        values = list(group.values.values())
        if told[1] == "Bits":
            bits = 0
            for value in values:
                bits |= 1 << value if told[3] else value
            values = [bits]
        for name in told[2].split(" and "):
            if name not in known:
                raise SchemaError(f"{interface.source}: constants: {group.doc!r}: there is no field {name}")
            found[name] = values
    return found


def _full_name(interface: Interface, struct: Struct) -> str:
    """As MessageDef has it."""
    return struct.name if interface.name == COMMON else f"{interface.name}::{struct.name}"


def _field(schema: Schema, rows: dict, step: str, f: Field, choices: list[int] | None, lists: list[str]) -> str:
    kind = f"k{f.type.title()}" if f.type in SCALARS else "kStruct"
    shape = "kCount" if step == "count" else "kList" if f.has_count else "kFixed" if f.is_array else "kOne"
    # A part that may be of several units is of the first one.
    units = [unit.strip().split(" or ")[0] for unit in f.unit.split(",")] if f.unit else []
    row = 0 if f.is_scalar else rows[f.owner, f.type]
    return (f'    {{"{f.name}", {kind}, {shape}, {row}, {f.length or f.max or 1}, {"true" if f.frame else "false"}, '
            f"{parts_of(schema, f) // (f.length or 1)}, {_list(lists, 'std::string_view', [_quoted(u) for u in units])}, "
            f"{_list(lists, 'std::int32_t', [str(c) for c in choices or []])}}},")


def _quoted(text: str) -> str:
    return f'"{text}"'


def _list(lists: list[str], kind: str, values: list[str]) -> str:
    """The name of a constant list, which is added to `lists` unless it is there."""
    if not values:
        return "{}"
    body = f"[] = {{{', '.join(values)}}};"
    for line in lists:
        if line.startswith(f"constexpr {kind} ") and line.endswith(body):
            return line.split()[2].partition("[")[0]
    name = f"kList{len(lists)}"
    lists.append(f"constexpr {kind} {name}{body}")
    return name
