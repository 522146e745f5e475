"""Fields of each kind for viewers, at both ends of the connection: playhouse/replicate/generated/ and web/src/protocol/generated/.

A kind's `[[viewer]]` fields are sent in three forms: as JSON with its prototype (`start`), as bits of the model's state
(`bit`), and as one *view*, a list of integers (of `changed` without bits, `selected` or `shown`); a kind has at most one
view.
"""

from __future__ import annotations

from dataclasses import dataclass

from codegen.checks import SchemaError
from codegen.emit_kinds_cpp import BANNER, enumerator
from codegen.kind_state import Shown, milli
from codegen.kind_words import Word
from codegen.kinds import BASE, Kind, Kinds

FOLDER = "playhouse/replicate/generated"
WEB_FOLDER = "web/src/protocol/generated"

SUBSCRIBED = 1      # the lowest bit of a state, of any kind; those of its kind follow
BITS = 8

# Quantum -> (C++ that gives the whole number, what one is worth in its unit, the unit).
QUANTA = {"1/1000": ("quantize({}, 1000)", 1e-3, ""), "J": ("quantize({}, 1)", 1, "J"), "px": ("static_cast<std::int32_t>({})", 1, "px"),
          "1/65536 turn": ("quantize_angle({})", 1, "rad")}
CODES = {"varint": "kVarint", "zigzag": "kZigzag", "turn": "kTurn", "rgba": "kRgba"}
# Type of a word -> C++ that writes the member as JSON (functions of playhouse/replicate/json_text.h), and its type there.
JSON = {"length": ("number({})", "number"), "angle": ("number({})", "number"), "number": ("number({})", "number"),
        "integer": ("number({})", "number"), "count": ("number({})", "number"), "flag": ("({} ? 1 : 0)", "number"),
        "pose": ("pose({})", "Pose"), "size": ("size({})", "[number, number, number]"), "color": ("color({})", "Rgba"),
        "text": ("quoted({})", "string")}


@dataclass
class View:
    """Fields of a kind that are sent during a run."""

    kind: Kind
    when: str
    column: str             # that holds a list of records; "" where a view is one record
    fields: list[Shown]


def emit(kinds: Kinds) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {f"{FOLDER}/views.cc": _cpp(kinds), f"{WEB_FOLDER}/views.ts": _typescript(kinds)}


def views(kinds: Kinds) -> list[View]:
    return [v for k in kinds.simulated() + kinds.traits() if k.name != BASE and (v := _view(k))]


def _view(kind: Kind) -> View | None:
    fields = [s for s in kind.state.viewer if s.when != "start" and s.code != "bit"]
    if not fields:
        return None
    lists = {c.name for c in kind.state.columns if c.list}
    sources = {s.source.partition(".")[0] if s.source.partition(".")[0] in lists else "" for s in fields}
    if len({s.when for s in fields}) > 1 or len(sources) > 1:
        raise SchemaError(f"{kind.source}: a viewer gets one record or one list of a kind, all of it at one time")
    return View(kind, fields[0].when, sources.pop(), fields)


def _quantum(shown: Shown) -> tuple[str, float, str]:
    if unit := milli(shown.quantum):
        return "quantize({}, 1000)", 1e-3, unit
    return QUANTA[shown.quantum] if shown.quantum else ("static_cast<std::int32_t>({})", 1, "")


def _bits(kind: Kind) -> list[tuple[Shown, int]]:
    found = [s for s in kind.state.viewer if s.code == "bit" and kind.name != BASE]
    if len(found) >= BITS:
        raise SchemaError(f"{kind.source}: a state has {BITS} bits")
    return [(s, SUBSCRIBED << (i + 1)) for i, s in enumerate(found)]


def _start(kind: Kind) -> list[Shown]:
    return [s for s in kind.state.viewer if s.when == "start"]


# --- the program ---------------------------------------------------------------------------------------------------


def _cpp(kinds: Kinds) -> str:
    shown = views(kinds)
    lines = [BANNER.rstrip(), '#include "playhouse/replicate/views.h"', "", "#include <fmt/format.h>", "", "#include <iterator>", "#include <string>", "#include <string_view>",
             "", '#include "playhouse/replicate/json_text.h"', '#include "playhouse/replicate/quantize.h"',
             '#include "playhouse/scene/forms/colors.h"', '#include "playhouse/world/traits.h"', "",
             "namespace playhouse::replicate {", "namespace {", ""]
    for view in shown:
        lines += _row_of(view.kind) + _capture(view)
    for view in shown:
        codes = ", ".join(f"Code::{CODES[s.code]}" for s in view.fields)
        lines.append(f"constexpr Code kCodesOf{enumerator(view.kind.name)[1:]}[] = {{{codes}}};")
    lines += ["", f"constexpr KindView kViews[{len(shown)}] = {{"]
    for view in shown:
        name = enumerator(view.kind.name)[1:]
        lines.append(f"    {{When::k{view.when.title()}, {_bool(view.kind.measures)}, {_bool(view.column)}, kCodesOf{name}, "
                     f"row_of_{view.kind.name}, capture_{view.kind.name}}},")
    lines += ["};", "", "}  // namespace", "", "std::span<const KindView> views() { return kViews; }", ""]
    lines += _state(kinds) + _sensing(kinds) + _json(kinds)
    return "\n".join([*lines, "}  // namespace playhouse::replicate", ""])


def _bool(value: object) -> str:
    return "true" if value else "false"


def _row_of(kind: Kind) -> list[str]:
    """The model's row in the table of its kind, or of the trait."""
    found = f"world.models.kind[model] == scene::ModelKind::{enumerator(kind.kind)} ? world.models.part[model] : world::KindRow{{}}"
    if kind.entity == "trait":
        found = f"{{world::trait_row(world.{kind.table}, model).index}}"
    return [f"world::KindRow row_of_{kind.name}(const world::World& world, world::ModelRow model) {{", f"  return {found};", "}", ""]


def _value(view: View, shown: Shown) -> str:
    column, _, part = shown.source.partition(".")
    place = "item" if view.column else f"world.{view.kind.table}.{column}[row]"
    source = f"{place}.{part}" if part else place
    record = next((r for r in view.kind.state.records for c in view.kind.state.columns if c.name == column and c.type == r.name), None)
    types = {f.name: f.type for f in record.fields} if record else {}
    types |= {c.name: c.type for c in view.kind.state.columns if not part}
    if types.get(part or column) == "ModelId":
        return f"static_cast<std::int32_t>({source}.value)"
    if types.get(part or column) == "color":
        return f"static_cast<std::int32_t>(scene::rgba8({source}))"
    return _quantum(shown)[0].format(source)


def _capture(view: View) -> list[str]:
    lines = [f"bool capture_{view.kind.name}(const world::World& world, world::KindRow row, std::vector<std::int32_t>& out) {{"]
    if view.kind.measures and view.when != "changed":
        lines.append(f"  if (world.{view.kind.table}.measured_tick[row] == 0) return false;")
    pushes = [f"out.push_back({_value(view, s)});" for s in view.fields]
    if view.column:
        lines += [f"  for (const auto& item : world.{view.kind.table}.{view.column}[row]) {{", *(f"    {p}" for p in pushes), "  }"]
    else:
        lines += [f"  {p}" for p in pushes]
    return [*lines, "  return true;", "}", ""]


def _state(kinds: Kinds) -> list[str]:
    lines = ["std::uint8_t state_bits(const world::World& world, world::ModelRow model) {",
             "  [[maybe_unused]] const world::KindRow row = world.models.part[model];",
             f"  unsigned bits = world.models.subscribers[model] > 0 ? {SUBSCRIBED} : 0;", "  switch (world.models.kind[model]) {"]
    for kind in kinds.simulated():
        bits = _bits(kind)
        if bits:
            lines.append(f"    case scene::ModelKind::{enumerator(kind.kind)}:")
            lines += [f"      if (world.{kind.table}.{s.source}[row]) bits |= {bit};" for s, bit in bits]
            lines.append("      break;")
    return [*lines, "    default:", "      break;", "  }", "  return static_cast<std::uint8_t>(bits);", "}", ""]


def _sensing(kinds: Kinds) -> list[str]:
    lines = ["bool may_be_watched(scene::ModelKind kind) {", "  switch (kind) {"]
    lines += [f"    case scene::ModelKind::{enumerator(k.kind)}:" for k in kinds.simulated() if k.may_be_watched]
    return [*lines, "      return true;", "    default:", "      return false;", "  }", "}", ""]


def _members(kind: Kind, others: Kind) -> dict[str, tuple[Word, str]]:
    """Word -> (it, "" or "base"): a kind's own, or of all models."""
    return {w.name: (w, "base") for w in others.words} | {w.name: (w, "") for w in kind.words}


def _json_fields(kind: Kind, base: Kind, own: str) -> list[str]:
    """Statements that append the start fields; `own` holds the kind's members."""
    lines = []
    for shown in _start(kind):
        word, where = _members(kind, base)[shown.source]
        if word.type == "tuple":
            value = " + ',' + ".join(f"number({own}{p.member})" for p in word.parts)
            lines.append(f'  text += ",\\"{shown.field}\\":[" + {value} + "]";')
            continue
        if word.type == "choice":
            lines += [f"  static constexpr std::string_view {_words(word)}[] = {{{', '.join(f'{chr(34)}{v.word}{chr(34)}' for v in word.values)}}};",
                      f'  text += ",\\"{shown.field}\\":" + quoted({_words(word)}[static_cast<std::size_t>({own}{word.member})]);']
            continue
        if word.type not in JSON:
            raise SchemaError(f"{kind.source}: viewer {shown.field}: a {word.type} does not travel as json yet")
        held, write = f"{'model.' if where else own}{word.member}", JSON[word.type][0]
        value = write.format(held)
        if word.indexed:
            value = f"list({held}, [](const auto& each) {{ return {write.format('each')}; }})"
        lines.append(f'  fmt::format_to(std::back_inserter(text), ",\\"{shown.field}\\":{{}}", {value});')
    return lines


def _words(word: Word) -> str:
    return "kWordsOf" + enumerator(word.name)[1:]


def _json(kinds: Kinds) -> list[str]:
    base = kinds.find(BASE)
    lines, cases = ["namespace {", ""], []
    for kind in kinds.simulated():
        parts = [p for p in kinds.parts_of(kind) if _start(p)] if kind.name != BASE else []
        if kind.name == BASE or not (_start(kind) or parts):
            continue
        lines.append(f"void tell_{kind.name}(const scene::ModelDesc& model, std::string& text) {{")
        if _start(kind):
            if kind.members:
                lines.append(f"  if (!model.{kind.name}) return;")
            lines += _json_fields(kind, base, f"model.{kind.name}->")
        for part in parts:
            lines += ["  std::string all;", f"  for (const scene::{part.desc}& each : model.{part.table}) {{", "    std::string fields;",
                      *(f"  {line.replace('(text)', '(fields)').replace('text +=', 'fields +=')}" for line in _json_fields(part, base, "each.")),
                      "    all += (all.empty() ? \"{\" : \",{\") + fields.substr(1) + '}';", "  }",
                      f'  text += ",\\"{part.table}\\":[" + all + \']\';']
        lines += ["}", ""]
        cases += [f"    case scene::ModelKind::{enumerator(kind.kind)}:", f"      tell_{kind.name}(model, text);", "      break;"]
    lines += ["}  // namespace", "", "void tell_kind(const scene::ModelDesc& model, std::string& text) {", "  switch (model.kind) {"]
    lines += cases + ["    default:", "      break;", "  }", *_traits(kinds), "}", "", "std::string_view kind_name(scene::ModelKind kind) {",
                      "  switch (kind) {"]
    for kind in kinds.simulated():
        lines += [f"    case scene::ModelKind::{enumerator(kind.kind)}:", f'      return "{kind.kind}";']
    return [*lines, "  }", '  return "";', "}", ""]


def _traits(kinds: Kinds) -> list[str]:
    """Statements that append which traits a model has."""
    lines = ["  std::string traits;"]
    for trait in kinds.traits():
        lines.append(f'  if (scene::has_{trait.name}(model)) traits += R"(,"{trait.name}")";')
    return [*lines, """  if (!traits.empty()) text += R"(,"traits":[)" + traits.substr(1) + ']';"""]


# --- the page ------------------------------------------------------------------------------------------------------


def _typescript(kinds: Kinds) -> str:
    shown = views(kinds)
    lines = [BANNER.rstrip(), "import type { Pose, Rgba } from '../scene';", "", "/** The kind of a model. */",
             "export type Kind = " + " | ".join(f"'{k.kind}'" for k in kinds.simulated()) + ";", "",
             "/** Optional traits of models of any kind. */", "export type Trait = " + " | ".join(f"'{k.name}'" for k in kinds.traits()) + ";", "",
             "/** Bits of a model's state; bits of a kind apply to models of that kind only. */",
             "export const kBits = {", f"  subscribed: {SUBSCRIBED},"]
    for kind in kinds.simulated():
        if _bits(kind):
            lines.append(f"  {kind.name}: {{ " + ", ".join(f"{s.field}: {bit}" for s, bit in _bits(kind)) + " },")
    lines += ["} as const;", ""]
    for view in shown:
        lines += [f"/** {view.kind.doc} SI units and radians. */", f"export interface {_pascal(view.kind)}View {{"]
        lines += [f"  {s.field}: number;{_unit(s)}" for s in view.fields] + ["}", ""]
    lines += ["/** Per kind, the fields sent during a run. */", "export interface Views {"]
    lines += [f"  {v.kind.name}: {_pascal(v.kind)}View{'[]' if v.column else ''};" for v in shown] + ["}", ""]
    lines += ["export type Code = " + " | ".join(f"'{c}'" for c in CODES) + ";", "",
              "/** Encoding of a view: the code of each number, what one on the way is worth, and in which unit. */",
              "export interface ViewFormat {", "  kind: keyof Views;", "  list: boolean;",
              "  fields: readonly (readonly [name: string, code: Code, worth: number, unit: string])[];", "}", "",
              "export const kViews: readonly ViewFormat[] = ["]
    for view in shown:
        fields = ", ".join(f"['{s.field}', '{s.code}', {_quantum(s)[1]!r}, '{_quantum(s)[2]}']" for s in view.fields)
        lines += [f"  {{ kind: '{view.kind.name}', list: {'true' if view.column else 'false'}, fields: [{fields}] }},"]
    lines += ["];", ""]
    lines += _starts(kinds)
    return "\n".join(lines)


def _pascal(kind: Kind) -> str:
    return enumerator(kind.name)[1:]


def _unit(shown: Shown) -> str:
    unit = _quantum(shown)[2]
    return f" // {unit}{', in (-pi, pi]' if shown.code == 'turn' else ''}" if unit else ""


def _starts(kinds: Kinds) -> list[str]:
    base = kinds.find(BASE)
    lines = []
    for kind in kinds.simulated():
        if kind.name == BASE:
            continue
        for part in (p for p in kinds.parts_of(kind) if _start(p)):
            lines += [f"/** {part.doc} */", f"export interface {_pascal(part)} {{", *_fields(part, base), "}", ""]
    lines += ["/** Fields of the prototype of a model; only those of its kind are present. */",
              "export interface KindStart {"]
    for kind in kinds.simulated():
        if kind.name == BASE:
            continue
        lines += [line.replace(": ", "?: ", 1) for line in _fields(kind, base)]
        lines += [f"  {part.table}?: {_pascal(part)}[]; // {kind.name}" for part in kinds.parts_of(kind) if _start(part)]
    return [*_unique(lines), "  traits?: Trait[];", "}", ""]


def _unique(lines: list[str]) -> list[str]:
    """Kinds may share a field of the same name and type."""
    out: list[str] = []
    for line in lines:
        name = line.partition("?:")[0]
        if "?:" in line and any(o.startswith(name + "?:") for o in out):
            continue
        out.append(line)
    return out


def _json_type(word: Word) -> str:
    return " | ".join(f"'{v.word}'" for v in word.values) if word.type == "choice" else JSON[word.type][1]


def _fields(kind: Kind, base: Kind) -> list[str]:
    lines = []
    for shown in _start(kind):
        word, _ = _members(kind, base)[shown.source]
        to = "[" + ", ".join(["number"] * len(word.parts)) + "]" if word.parts else _json_type(word)
        to += "[]" if word.indexed else ""
        lines.append(f"  {shown.field}: {to};" + (f" // {shown.unit}" if shown.unit else ""))
    return lines
