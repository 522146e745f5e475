/// The walls of a model as a grid, as interface map (docs/drivers.md). They do not change during a run.

#include "playhouse/wire/generated/map.h"

#include <fmt/format.h>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/bodies/plan_of_solids.h"
#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/drivers/grid_map/grid_map.h"

namespace playhouse::drivers {
namespace {

using wire::MessageType;

bool is_part_of(const world::World& world, world::ModelRow part, world::ModelRow model) {
  for (world::ModelRow row = part; row; row = world.models.parent[row])
    if (row == model) return true;
  return false;
}

/// By rows from the bottom, as the interface has them.
GridMap grid_of(const scene::Plan& plan) {
  GridMap map;
  map.info = {static_cast<float>(plan.resolution),
              static_cast<std::uint32_t>(plan.solid.width),
              static_cast<std::uint32_t>(plan.solid.height),
              {plan.X_WI.x, plan.X_WI.y, 0}};
  map.cells.reserve(plan.solid.solid.size());
  for (int y = plan.solid.height - 1; y >= 0; --y)
    for (int x = 0; x < plan.solid.width; ++x) map.cells.push_back(plan.solid.at(x, y) ? 1 : -1);
  return map;
}

/// The walls at its map_height, all that stand still of the model and its parts. Error text for the log.
Result<GridMap> map_of(const world::World& world, world::ModelRow model) {
  const double resolution = world.desc(model).map_resolution, height = world.desc(model).map_height;
  if (resolution == 0) return Error{"", "its map_resolution is 0"};
  bodies::Shapes shapes(world.scene());
  const bodies::Solids solids = bodies::make_fixed_solids(world, shapes);
  const Result<scene::Plan> plan = bodies::plan_of_solids(solids, resolution, [&](bodies::SolidRow row) {
    return bodies::is_wall_at(solids, row, height) && is_part_of(world, solids.model[row], model);
  });
  if (!plan) return Error{"", "it " + plan.error().text + ": give it a larger map_resolution"};
  if (plan->solid.width == 0)
    return Error{"", fmt::format("it has no fixed walls {} m above the floor (map_height)", height)};
  return grid_of(*plan);
}

class Map final : public SimulatedDevice {
 public:
  Map(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)), map_(map_of(simulation.world(), model)) {
    if (!map_)
      log::warn("model {} has no map: {}", in_quotes(simulation.world().name(model)), map_.error().text);
  }

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {{MessageType::kReq, wire::map::kReqGetInfo},
                                         {MessageType::kReq, wire::map::kReqGetData},
                                         {MessageType::kReq, wire::map::kReqGetVector}};
    return kServed;
  }

  void request(const device::Message& message, device::Replier replier) override {
    if (!map_) return;
    if (message.subtype == wire::map::kReqGetVector) {
      if (const auto lines = map_lines(*map_)) replier.ack(wire::encode(*lines));
      return;
    }
    answer_map_request(*map_, message, std::move(replier));
  }

 private:
  const Result<GridMap> map_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_map_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Map>(simulation, model);
}

}  // namespace playhouse::drivers
