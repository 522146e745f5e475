#include "playhouse/bridge/simulated/model_interfaces.h"

#include <algorithm>

#include "playhouse/base/assert.h"

namespace playhouse::drivers {

using scene::KindInterface;
using scene::Need;

namespace {

bool has_contacts_or_lamps(const world::World& world, world::ModelRow model) {
  bool found = false;
  each_part(world, model, [&](world::ModelRow part) {
    const scene::ModelKind kind = world.models.kind[part];
    found = found || kind == scene::ModelKind::kBumper || is_lamp(kind);
  });
  return found;
}

}  // namespace

std::span<const KindInterface> interfaces_of(const world::World& world, world::ModelRow model) {
  const scene::ModelKind kind = world.models.kind[model];
  const scene::Kind& row = scene::kinds()[static_cast<std::size_t>(kind)];  // kinds are in numeric order
  PLAYHOUSE_ASSERT(row.simulated && row.kind == kind);
  return row.interfaces;
}

std::span<const KindInterface> interfaces_of_every_kind() {
  return scene::kinds()[static_cast<std::size_t>(scene::ModelKind::kPlain)].interfaces;
}

bool has(const world::World& world, world::ModelRow model, Need need) {
  const std::vector<scene::RangerSensorDesc>& sensors = world.desc(model).sensors;
  switch (need) {
    case Need::kNothing:
      return true;
    case Need::kScanner:
      return std::ranges::any_of(sensors, [](const auto& sensor) { return sensor.samples > 1; });
    case Need::kSeveralSensors:
      return sensors.size() > 1;
    case Need::kRings:
      return std::ranges::any_of(sensors, [](const auto& sensor) { return sensor.rings > 1; });
    case Need::kBaseline: {
      const auto& camera = world.desc(model).camera;
      return camera && camera->baseline > 0;
    }
    case Need::kRobot:
      return is_robot(world, model);
    case Need::kContactsOrLamps:
      return has_contacts_or_lamps(world, model);
    case Need::kNever:
      return false;
  }
  return false;
}

bool is_robot(const world::World& world, world::ModelRow model) {
  return world.models.root[model] == model && world.models.kind[model] == scene::ModelKind::kPosition;
}

bool fits(const world::World& world, world::ModelRow model, std::uint16_t interf) {
  bool fits = false;
  each_interface(world, model, [&](const KindInterface& each) {
    fits = fits || (each.code == interf && has(world, model, each.when));
  });
  return fits;
}

bool is_listed(const world::World& world, world::ModelRow model, std::uint16_t interf) {
  bool listed = false;
  each_interface(world, model, [&](const KindInterface& each) {
    listed = listed || (each.code == interf && has(world, model, each.listed));
  });
  return listed;
}

bool is_shared(std::uint16_t interf) {
  return std::ranges::any_of(scene::kinds(), [=](const scene::Kind& kind) {
    return std::ranges::any_of(kind.interfaces,
                               [=](const KindInterface& each) { return each.code == interf && each.shared; });
  });
}

bool is_simulated(std::uint16_t interf) {
  return std::ranges::any_of(scene::kinds(), [=](const scene::Kind& kind) {
    return kind.simulated &&
           std::ranges::find(kind.interfaces, interf, &KindInterface::code) != kind.interfaces.end();
  });
}

}  // namespace playhouse::drivers
