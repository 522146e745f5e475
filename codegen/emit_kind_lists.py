"""Lists of hand-written code per kind, and power consumption, for engines and drivers; so that a kind adds files and changes none. In the folders
`generated` of playhouse/scene/, behaviour/, bodies/, senses/ and bridge/."""

from __future__ import annotations

from codegen.emit_kinds_cpp import BANNER, enumerator
from codegen.kinds import BASE, Kind, Kinds, Served

SCENE = "playhouse/scene/generated"
BEHAVIOUR = "playhouse/behaviour/generated"
BODIES = "playhouse/bodies/generated"
SENSES = "playhouse/senses/generated"
BRIDGE = "playhouse/bridge/generated"


def emit(kinds: Kinds) -> dict[str, str]:
    """Path from the root of the tree -> content."""
    return {f"{SCENE}/bodies.h": _bodies(kinds), f"{BEHAVIOUR}/acts.h": _acts(kinds), f"{BEHAVIOUR}/draws.h": _draws(kinds),
            f"{SENSES}/senses.h": _senses(kinds), f"{BODIES}/moves.h": _moves(kinds), f"{BRIDGE}/device_makers.h": _devices(kinds),
            f"{BRIDGE}/voltages.cc": _voltages(kinds)}


def _bodies(kinds: Kinds) -> str:
    found = [k for k in kinds.simulated() if k.body and k.body.form]
    lines = [BANNER.rstrip(), "#pragma once", "", "/// Bodies specific to kinds, each built by playhouse/scene/forms/body_NAME.cc.", "",
             '#include "playhouse/scene/forms/body.h"', "", "namespace playhouse::scene {", ""]
    lines += [f"void make_{k.name}_body(const geom::Size& size, ModelDesc& model);" for k in found]
    lines += ["", "/// Gives a model the body of its kind, which fills `size`.",
              "inline void make_body(const geom::Size& size, ModelDesc& model) {", "  switch (model.kind) {"]
    for kind in found:
        lines += [f"    case ModelKind::{enumerator(kind.kind)}:", f"      return make_{kind.name}_body(size, model);"]
    return "\n".join([*lines, "    default:", "      model.blocks.push_back(box_block(size));", "  }", "}", "",
                      "}  // namespace playhouse::scene", ""])


def _acts(kinds: Kinds) -> str:
    found = [k for k in kinds.simulated() if k.acts]
    lines = [BANNER.rstrip(), "#pragma once", "", "/// Act phases of kinds, each defined in playhouse/behaviour/act_NAME.cc.", "",
             "#include <memory>", "", '#include "playhouse/behaviour/act_phase.h"', "", "namespace playhouse::behaviour {", ""]
    lines += [f"std::unique_ptr<ActPhase> make_{k.name}_act();" for k in found]
    lines += ["", "inline void add_acts(Acts& acts) {"]
    lines += [f"  acts.add(make_{k.name}_act());" for k in found]
    return "\n".join([*lines, "}", "", "}  // namespace playhouse::behaviour", ""])


def _draws(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), "#pragma once", "", '#include "playhouse/scene/scene_desc.h"', "", "namespace playhouse::behaviour {", "",
             "/// Power consumption of a subscribed model, without motion: that of its kind, else of its words. [W]",
             "inline double draw_of(const scene::ModelDesc& model) {", "  switch (model.kind) {"]
    for kind in kinds.simulated():  # the switch has a default: other kinds have no draw of their own
        parts = [p for p in kinds.parts_of(kind) if p.watts is not None and kind.name != BASE]
        if kind.watts is None and not parts:
            continue
        terms = [f"{kind.watts!r}"] if kind.watts is not None else []
        terms += [f"{p.watts!r} * static_cast<double>(model.{p.table}.size())" for p in parts]
        lines += [f"    case scene::ModelKind::{enumerator(kind.kind)}:", f"      return {' + '.join(terms)};"]
    return "\n".join([*lines, "    default:", "      return model.watts;", "  }", "}", "", "}  // namespace playhouse::behaviour", ""])


def _senses(kinds: Kinds) -> str:
    found = [k for k in kinds.simulated() if k.measures]
    lines = [BANNER.rstrip(), "#pragma once", "", "/// Sense phases of kinds, each defined in playhouse/senses/sense_NAME.cc.", "",
             "#include <memory>", "", '#include "playhouse/senses/sense_phase.h"', "", "namespace playhouse::senses {", "",
             "/// `workers` is the maximum number of concurrent threads."]
    lines += [f"std::unique_ptr<SensePhase> make_{k.name}_sense(unsigned workers);" for k in found]
    lines += ["", "/// Factories of the phase of each kind; an engine with other sensor models has its own.", "struct SenseMakers {",
              "  using Make = std::unique_ptr<SensePhase> (*)(unsigned workers);"]
    lines += [f"  Make {k.name} = make_{k.name}_sense;" for k in found]
    lines += ["};", "", "inline void add_senses(Senses& senses, unsigned workers, const SenseMakers& makers = {}) {"]
    lines += [f"  senses.add(makers.{k.name}(workers));" for k in found]
    return "\n".join([*lines, "}", "", "}  // namespace playhouse::senses", ""])


def _moves(kinds: Kinds) -> str:
    """The first kind, the most frequent one, is the default branch."""
    first, *others = [k for k in kinds.simulated() if k.moves]
    lines = [BANNER.rstrip(), "#pragma once", "",
             "/// Motion of each kind that moves by itself, by functions of playhouse/bodies/move_NAME.h.", ""]
    lines += [f'#include "playhouse/bodies/move_{name}.h"' for name in sorted(k.name for k in [first, *others])]
    lines += ["", "namespace playhouse::bodies {", "", "/// Calls visit(functions) with the functions of a kind that moves.",
              "template <typename Visit>",
              f"decltype(auto) with_move({'' if others else '[[maybe_unused]] '}scene::ModelKind kind, const Visit& visit) {{"]
    lines += [f"  if (kind == scene::ModelKind::{enumerator(k.kind)}) return visit({enumerator(k.name)[1:]}Move{{}});" for k in others]
    return "\n".join([*lines, f"  return visit({enumerator(first.name)[1:]}Move{{}});", "}", "", "}  // namespace playhouse::bodies", ""])


def _makers(kinds: Kinds) -> list[tuple[str, Served, Kind]]:
    """The name of each, for which interface and kind it is."""
    found: list[tuple[str, Served, Kind]] = []
    for kind in kinds.simulated() + kinds.traits():
        for served in kind.interfaces:
            is_first = served.name not in {name for name, _, _ in found}
            found.append((served.name if is_first else f"{kind.name}_{served.name}", served, kind))
    return found


def _voltages(kinds: Kinds) -> str:
    lines = [BANNER.rstrip(), '#include "playhouse/bridge/analog_sensor.h"', "", "namespace playhouse::drivers {", ""]
    for name, served, kind in _makers(kinds):
        if not served.voltages:
            continue
        values = ", ".join(f"static_cast<float>({v.volts!r} * sensors.{v.column}[row])" for v in served.voltages)
        lines += [f"std::unique_ptr<SimulatedDevice> make_{name}_device(run::Simulation& simulation, world::ModelRow model) {{",
                  "  return make_analog_sensor(simulation, model, [](const world::World& world, world::KindRow row, std::vector<float>& voltages) {",
                  f"    const auto& sensors = world.{kind.table};", "    if (sensors.measured_tick[row] != world.tick()) return false;",
                  f"    voltages = {{{values}}};", "    return true;", "  });", "}", ""]
    return "\n".join([*lines, "}  // namespace playhouse::drivers", ""])


def _devices(kinds: Kinds) -> str:
    found = _makers(kinds)
    lines = [BANNER.rstrip(), "#pragma once", "",
             "/// The device of each interface of simulated models, defined in a NAME.cc below playhouse/bridge/interfaces/,",
             "/// and devices specific to a kind, with NAME of the kind. Those with `voltages` are in voltages.cc.", "",
             "#include <cstdint>", "#include <memory>", "#include <optional>", "", '#include "playhouse/bridge/simulated/simulated_device.h"', "",
             "namespace playhouse::drivers {", "", "/// `model` fits the interface (model_interfaces.h)."]
    lines += [f"std::unique_ptr<SimulatedDevice> make_{name}_device(run::Simulation& simulation, world::ModelRow model);" for name, _, _ in found]
    lines += ["", "struct DeviceMaker {", "  std::uint16_t interf;",
              "  std::optional<scene::ModelKind> kind;  // any kind, if empty",
              "  std::unique_ptr<SimulatedDevice> (*make)(run::Simulation& simulation, world::ModelRow model);", "};",
              "inline constexpr DeviceMaker kDeviceMakers[] = {"]
    for name, served, kind in found:
        of = f"scene::ModelKind::{enumerator(kind.kind)}" if kind.entity == "model" and kind.name != BASE else "std::nullopt"
        lines.append(f"    {{{served.code}, {of}, make_{name}_device}},")
    return "\n".join([*lines, "};", "", "}  // namespace playhouse::drivers", ""])
