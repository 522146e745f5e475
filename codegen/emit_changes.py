"""C++ for the changes of a world, in playhouse/world/generated/, and their reference page, docs/changes.md."""

from __future__ import annotations

from codegen.changes import GIVES, Change
from codegen.emit_kinds_cpp import BANNER, _comment, enumerator
from codegen.emit_kinds_docs import _table
from codegen.emit_tables import FOLDER, _title
from codegen.kinds import BASE, Kind, Kinds

PAGE = "docs/changes.md"
NAMESPACE = ["namespace playhouse::world {", ""]


def emit(kinds: Kinds) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {f"{FOLDER}/changes.h": _header(kinds), f"{FOLDER}/apply_changes.cc": _source(kinds), PAGE: _page(kinds)}


def _owned(kinds: Kinds) -> list[tuple[Kind, Change]]:
    return [(k, c) for k in kinds.all for c in k.changes]


def _row(kind: Kind) -> str:
    return "ModelRow" if kind.name == BASE else f"{_title(kind.name)}Row"


def _struct(kind: Kind, change: Change) -> list[str]:
    members = [f"  {f.member()};" + (f"  // {f.unit}" if f.unit else "") for f in change.fields]
    names = [f.name for f in change.fields]
    if kind.entity != "world":
        members, names = ["  ModelId model;", *members], ["model", *names]
    lines = [*_comment(change.doc.replace("`", "")), f"struct {change.struct} {{",
             f'  static constexpr std::string_view kName = "{change.name}";', *members]
    if names:
        lines += ["  template <typename Self, typename Visit>", "  static void each_field(Self& self, const Visit& visit) {",
                  *(f'    visit("{name}", self.{name});' for name in names), "  }"]
    else:
        lines += ["  template <typename Self, typename Visit>", "  static void each_field(Self&, const Visit&) {}"]
    return [*lines, "};", ""]


def _header(kinds: Kinds) -> str:
    owned = _owned(kinds)
    lines = [BANNER.rstrip(), "#pragma once", "",
             "/// The changes of a world between two ticks: a closed list. Journal::apply() alone makes them in a run,",
             "/// and keeps them in order; docs/changes.md lists them. Poses are by frames as in world.h.", "",
             "#include <cstddef>", "#include <cstdint>", "#include <memory>", "#include <string>", "#include <string_view>", "#include <variant>", "#include <vector>", "",
             '#include "playhouse/base/result.h"', '#include "playhouse/world/gripper.h"', "", *NAMESPACE, "namespace changes {", ""]
    for kind, change in owned:
        lines += _struct(kind, change)
    lines += _comment("Each applies one change. False, or a reason, and no effect: there is no such model of the kind, or as said above.")
    lines += [f"{GIVES[c.gives]} apply(World& world, const {c.struct}& change);" for _, c in owned]
    lines += ["", *_comment("What those do with the row of the model, by hand in world/changes/.")]
    lines += [f"{GIVES[c.gives]} carry_out(World& world, {_row(k)} row, const {c.struct}& change);" for k, c in owned if k.entity != "world"]
    lines += ["", "}  // namespace changes", "", "using Change = std::variant<", ",\n".join(f"    changes::{c.struct}" for _, c in owned) + ">;", "",
              *_comment("Applies any change; false if it cannot be."), "bool apply(World& world, const Change& change);", "",
              "}  // namespace playhouse::world", ""]
    return "\n".join(lines)


def _apply(kind: Kind, change: Change) -> list[str]:
    given = f"{GIVES[change.gives]} apply(World& world, const {change.struct}& change) {{"
    lines = [given, "  const ModelRow model = world.row(change.model);"]
    if kind.name == BASE:
        return [*lines, "  return model && carry_out(world, model, change);", "}", ""]
    if kind.entity == "trait":
        return [*lines, "  if (!model) return false;", f"  const {_row(kind)} row = trait_row(world.{kind.table}, model);",
                "  return row && carry_out(world, row, change);", "}", ""]
    return [*lines, f"  if (!model || world.models.kind[model] != scene::ModelKind::{enumerator(kind.kind)}) return false;",
            f"  return carry_out(world, {_row(kind)}(world.models.part[model]), change);", "}", ""]


def _source(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), "", '#include "playhouse/world/generated/changes.h"', '#include "playhouse/world/traits.h"', "",
             "namespace playhouse::world::changes {", ""]
    for kind, change in _owned(kinds):
        if kind.entity != "world":
            lines += _apply(kind, change)
    return "\n".join([*lines, "}  // namespace playhouse::world::changes", ""])


def _page(kinds: Kinds) -> str:
    lines = [f"<!-- {BANNER.strip().removeprefix('// ')} -->", "# Changes of a run", "",
             "What happens to a running world from outside, between two ticks, is one of these changes: by clients of devices, by pages, by",
             "learning programs. They are applied in one order, and [recordings](recording.md) and [nodes of a cluster](cluster.md) get exactly that list.",
             "`playhouse export run.mcap --changes` prints it.", ""]
    for kind in kinds.all:
        if not kind.changes:
            continue
        of = {"world": "Of the world", "trait": f"Of models with a {kind.name}"}.get(kind.entity, "Of any model" if kind.name == BASE else f"Of {'an' if kind.name[0] in 'aeiou' else 'a'} {kind.name}")
        rows = [[f"`{c.name}`", ", ".join(f"`{f.name}`" + (f" [{f.unit}]" if f.unit else "") for f in c.fields), c.doc] for c in kind.changes]
        lines += [f"## {of}", "", *_table(["change", "fields", "effect"], rows)]
    return "\n".join(lines).rstrip("\n") + "\n"
