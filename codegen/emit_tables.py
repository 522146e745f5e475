"""C++ for the tables of the world: playhouse/world/generated/. The table of all models is written by hand (world/models.h)."""

from __future__ import annotations

from codegen.emit_kinds_cpp import BANNER, _comment, enumerator
from codegen.kind_state import Quantity, Record
from codegen.kinds import BASE, Kind, Kinds

FOLDER = "playhouse/world/generated"

TYPES = {
    "flag": "std::uint8_t", "uint8": "std::uint8_t", "int32": "std::int32_t", "uint32": "std::uint32_t", "uint64": "std::uint64_t", "float32": "float",
    "float64": "double", "text": "std::string", "color": "scene::Color", "size": "geom::Size", "pose": "geom::Pose",
    "vector3": "geom::Vec3", "twist": "geom::Twist", "tilt": "geom::Tilt", "velocity6": "geom::SpatialVelocity", "ModelKind": "scene::ModelKind",
}
# Numbers of a value, in the order of world::each_number().
NUMBERS = {
    "color": ["red", "green", "blue", "alpha"], "size": ["x", "y", "z"], "pose": ["x", "y", "z", "heading"],
    "twist": ["x", "y", "z", "heading"], "vector3": ["x", "y", "z"], "tilt": ["x", "y"],
}
ZERO = {"flag", "uint8", "int32", "uint32", "uint64", "float32", "float64"}


def emit(kinds: Kinds) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {f"{FOLDER}/tables.h": _tables(kinds), f"{FOLDER}/table_columns.h": _columns(kinds), f"{FOLDER}/worded.h": _worded(kinds),
            f"{FOLDER}/part_names.h": _part_names(kinds)}


def tabled(kinds: Kinds) -> list[Kind]:
    """Kinds with a table, each followed by its parts with one, then traits."""
    models = [k for k in kinds.simulated() if k.table and k.name != BASE]
    return [each for k in models for each in [k, *(p for p in kinds.parts_of(k) if p.table)]] + kinds.traits()


def _title(name: str) -> str:
    return "".join(part.title() for part in name.split("_"))


def _table(kind: Kind) -> str:
    return _title(kind.table)


def _type(kinds: Kinds, column: Quantity) -> str:
    if column.type == "row":
        of = column.name.removeprefix("first_")
        owners = {"model": "Model", "beam": "Beam"} | {k.name: _title(k.name) for k in tabled(kinds)}
        return f"{owners[of]}Row"
    inner = TYPES.get(column.type, column.type)
    return f"std::vector<{inner}>" if column.list else inner


def _tables(kinds: Kinds) -> str:
    found = tabled(kinds)
    lines = [BANNER.rstrip(), "#pragma once", "",
             "/// The tables of the world: the state of each kind, in columns. Units, frames, roles and writers are in",
             "/// table_columns.h and on the pages of docs/kinds/.", "", "#include <cstdint>", "#include <string>", "#include <vector>", "",
             '#include "playhouse/world/models.h"', "", "namespace playhouse::world {", ""]
    lines += [f"using {_title(k.name)}Row = Row<struct {_title(k.name)}Table>;" for k in found]
    lines += ["using BeamRow = Row<struct BeamTable>;  // of the columns with a value for each beam", ""]
    for kind in found:
        for record in kind.state.records:
            lines += _record(record)
        lines += _struct(kinds, kind)
    lines += _moves(kinds)
    lines += _comment("The state, in columns; columns.h lists them all, with what each is to a run.")
    lines += ["struct Tables {", "  Models models;", *(f"  {_table(k)} {k.table};" for k in found), "};", "",
              "}  // namespace playhouse::world", ""]
    return "\n".join(lines)


def _moves(kinds: Kinds) -> list[str]:
    lines = [*_comment("Whether models of a kind move by themselves in the phase `move`, and take along what they carry."),
             "constexpr bool moves(scene::ModelKind kind) {", "  switch (kind) {"]
    lines += [f"    case scene::ModelKind::{enumerator(k.kind)}:" for k in kinds.simulated() if k.moves]
    return [*lines, "      return true;", "    default:", "      return false;", "  }", "}", ""]


def _record(record: Record) -> list[str]:
    lines = [*_comment(record.doc), f"struct {record.name} {{"]
    for f in record.fields:
        zero = " = 0" if f.type in ZERO else ""
        lines.append(f"  {TYPES.get(f.type, f.type)} {f.name}{zero};  // {_about(f)}")
    lines += [f"  friend bool operator==(const {record.name}&, const {record.name}&) = default;", "};", ""]
    names = ", ".join(f.name for f in record.fields)
    lines += ["/// Calls visit(part) for every part.", "template <typename Visit>",
              f"void each_part({record.name}& value, const Visit& visit) {{", f"  auto& [{names}] = value;",
              "  " + ", ".join(f"visit({f.name})" for f in record.fields) + ";", "}", "template <typename Visit>",
              f"void each_part(const {record.name}& value, const Visit& visit) {{", f"  const auto& [{names}] = value;",
              "  " + ", ".join(f"visit({f.name})" for f in record.fields) + ";", "}", ""]
    return lines


def _part_names(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), "#pragma once", "",
             "/// Names of the numbers of records, in the order of each_number(). \"(model)\" is behind that of a model's id.", "",
             '#include "playhouse/world/generated/tables.h"', "", "namespace playhouse::world {", "", "template <typename Record>",
             'inline constexpr const char* kPartNames = "";']
    for record in (record for kind in tabled(kinds) for record in kind.state.records):
        names = " ".join(name for f in record.fields for name in _numbers_of(f))
        lines += ["template <>", f"inline constexpr const char* kPartNames<{record.name}> =", f'    "{names}";']
    return "\n".join([*lines, "", "}  // namespace playhouse::world", ""])


def _numbers_of(field: Quantity) -> list[str]:
    if field.type in NUMBERS:
        return [f"{field.name}.{number}" for number in NUMBERS[field.type]]
    return [f"{field.name}(model)" if field.type == "ModelId" else field.name]


def _about(quantity: Quantity) -> str:
    unit = f" [{quantity.unit}]" if quantity.unit and quantity.unit != "1" else ""
    per = " (beams)" if quantity.per else ""
    return f"{quantity.doc}{unit}{per}"


def _struct(kinds: Kinds, kind: Kind) -> list[str]:
    lines = [*_comment(kind.doc), f"struct {_table(kind)} {{", f"  using Row = {_title(kind.name)}Row;"]
    own = f"{_title(kind.name)}Table"
    lines += [f"  ByRow<{'BeamTable' if c.per else own}, {_type(kinds, c)}> {c.name};  // {_about(c)}" for c in kind.state.columns]
    first = kind.state.columns[0].name
    return [*lines, f"  std::size_t size() const {{ return {first}.size(); }}", f"  RowsOf<{own}> rows() const {{ return {first}.rows(); }}", "};", ""]


def _columns(kinds: Kinds) -> str:
    found = tabled(kinds)
    lines = [BANNER.rstrip(), "#pragma once", "", "/// The columns of the tables of kinds and traits, and the table of each. For columns.h only.", "",
             "namespace playhouse::world {", ""]
    for kind in found:
        lines += ["template <>", f"struct ColumnsOf<{_table(kind)}> {{", f'  static constexpr const char* kTable = "{kind.table}";',
                  "  template <typename Visit>", "  static constexpr void each(const Visit& visit) {"]
        for c in kind.state.columns:
            per = ", Per::kBeam" if c.per else ""
            lines.append(f'    visit(Column{{"{kind.table}.{c.name}", Role::{enumerator(c.role)}, "{c.unit}", "{c.frame}", "{c.writer}", '
                         f"&{_table(kind)}::{c.name}{per}}});")
        lines += ["  }", "};", ""]
    lines += _comment("The kind whose models have a row each; of parts' and traits' tables there is none.")
    lines += ["template <typename Table>", "inline constexpr auto kKindOf = nullptr;"]
    for kind in found:
        if kind.entity == "model":
            lines += ["template <>",
                      f"inline constexpr scene::ModelKind kKindOf<{_table(kind)}> = scene::ModelKind::{enumerator(kind.kind)};"]
    lines += ["", *_comment("The trait whose models have a row each; of other tables there is none."), "template <typename Table>",
              "inline constexpr auto kHas = nullptr;"]
    for kind in kinds.traits():
        lines += ["template <>", f"inline constexpr auto kHas<{_table(kind)}> = scene::has_{kind.name};"]
    lines += ["template <typename Table>", "inline constexpr auto kTraitTable = nullptr;"]
    for kind in kinds.traits():
        lines += ["template <>", f"inline constexpr auto kTraitTable<{_table(kind)}> = &Tables::{kind.table};"]
    members = ", ".join(["&Tables::models", *(f"&Tables::{k.table}" for k in found)])
    lines += ["", f"inline constexpr std::tuple kTables{{{members}}};", "",
              *_comment("Those of kinds: a row for each model of the kind, in the order of the models."),
              "inline constexpr std::tuple kKindTables{" + ", ".join(f"&Tables::{k.table}" for k in found if k.entity == "model") + "};", "",
              *_comment("Those of traits: a row for each model that has it, in the order of the models."),
              "inline constexpr std::tuple kTraitTables{" + ", ".join(f"&Tables::{k.table}" for k in kinds.traits()) + "};",
              "", "}  // namespace playhouse::world", ""]
    return "\n".join(lines)


def _worded(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), "#pragma once", "",
             "/// State initialised by a word of world files, and saved by it with its current value.", "",
             '#include "playhouse/world/generated/tables.h"', "", "namespace playhouse::world {", "",
             *_comment("Gives the last row of a table what the model's words say. Tables without such columns stay as they are."),
             "template <typename Table>", "void begin_as_said(Table&, const scene::ModelDesc&) {}"]
    found = [(k, words) for k in kinds.simulated() if (words := _words(k))]
    for kind, words in found:
        lines += [f"inline void begin_as_said({_table(kind)}& table, const scene::ModelDesc& model) {{",
                  f"  if (!model.{kind.name}) return;",
                  *(f"  table.{c.name}.back() = model.{kind.name}->{member};" for c, member in words), "}"]
    lines += ["", *_comment("All such state of a model is what its words say."),
              "inline bool is_as_said(const Tables& tables, ModelRow model, const scene::ModelDesc& said) {",
              "  switch (said.kind) {"]
    for kind, words in found:
        differs = [f"static_cast<bool>(table.{c.name}[row]) == said.{kind.name}->{m}" if c.type == "flag" else
                   f"table.{c.name}[row] == said.{kind.name}->{m}" for c, m in words]
        lines += _case(kind, [f"return !said.{kind.name} || ({' && '.join(differs)});"])
    lines += ["    default:", "      return true;", "  }", "}", "",
              *_comment("Makes a model's words say all such state as it is."),
              "inline void say_as_is(const Tables& tables, ModelRow model, scene::ModelDesc& says) {",
              "  switch (says.kind) {"]
    for kind, words in found:
        lines += _case(kind, [f"if (!says.{kind.name}) says.{kind.name}.emplace();",
                              *(f"says.{kind.name}->{m} = table.{c.name}[row];" for c, m in words), "return;"])
    return "\n".join([*lines, "    default:", "      return;", "  }", "}", "", "}  // namespace playhouse::world", ""])


def _words(kind: Kind) -> list[tuple[Quantity, str]]:
    """Columns initialised by a word, each with the member of the description."""
    members = {w.name: w.member for w in kind.words}
    return [(c, members[c.word]) for c in kind.state.columns if c.word]


def _case(kind: Kind, statements: list[str]) -> list[str]:
    return [f"    case scene::ModelKind::{enumerator(kind.kind)}: {{", f"      const {_table(kind)}& table = tables.{kind.table};",
            f"      const {_title(kind.name)}Row row = tables.models.part[model];", *(f"      {s}" for s in statements), "    }"]
