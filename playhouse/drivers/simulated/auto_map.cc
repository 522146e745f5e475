#include "playhouse/drivers/simulated/auto_map.h"

#include <algorithm>

#include "playhouse/drivers/simulated/model_interfaces.h"

namespace playhouse::drivers {
namespace {

using scene::Index;
using scene::KindInterface;

constexpr std::size_t kIndices = 65536;  // of one interface on one port

/// Calls visit(code) for every interface whose indices are the robots' numbers.
template <typename Visit>
void each_numbered(const Visit& visit) {
  for (const scene::Kind& kind : scene::kinds()) {
    for (const KindInterface& each : kind.interfaces)
      if (kind.simulated && each.index == Index::kRobot) visit(each.code);
  }
}

}  // namespace

std::vector<world::ModelRow> top_models(const world::World& world) {
  std::vector<world::ModelRow> tops;
  for (std::uint32_t row = 0; row < world.models.size(); ++row)
    if (world.models.root[row] == row) tops.push_back({row});
  return tops;
}

std::vector<MappedDevice> AutoMap::of_world(const world::World& world) {
  for (const KindInterface& each : scene::world_kind().interfaces) add(each.code, 0, {});
  return of_trees(world, top_models(world));
}

std::vector<MappedDevice> AutoMap::of_trees(const world::World& world,
                                            std::span<const world::ModelRow> tops) {
  // All numbers of robots first: what comes in addition has the indices behind them.
  std::vector<std::pair<world::ModelRow, std::size_t>> robots;
  for (const world::ModelRow top : tops)
    if (is_robot(world, top)) robots.emplace_back(top, next_robot());
  for (const auto& [top, number] : robots) map_tree(world, top, number);
  for (const world::ModelRow top : tops)
    if (!is_robot(world, top)) map_tree(world, top, std::nullopt);
  for (const auto& [interf, model] : std::exchange(further_, {})) add(interf, next_[interf]++, model);
  return std::exchange(out_, {});
}

std::size_t AutoMap::next_robot() {
  std::size_t number = 0;
  each_numbered([&](std::uint16_t interf) { number = std::max(number, next_[interf]); });
  each_numbered([&](std::uint16_t interf) { next_[interf] = number + 1; });
  return number;
}

void AutoMap::map_tree(const world::World& world, world::ModelRow top, std::optional<std::size_t> robot) {
  robot_ = robot;
  numbered_.clear();
  visit(world, top);
}

void AutoMap::visit(const world::World& world, world::ModelRow model) {
  const KindInterface* const own = interfaces_of(world, model).data();
  each_interface(world, model, [&](const KindInterface& each) {
    if (!has(world, model, each.listed)) return;
    const bool is_its_own = &each == own;
    if (each.index == Index::kRobot && robot_ && numbered_.insert(each.code).second) {
      add(each.code, *robot_, model);
    } else if (each.index == Index::kCount || is_its_own) {
      add(each.code, next_[each.code]++, model);
    } else {
      further_.emplace_back(each.code, model);
    }
  });
  for (const std::uint32_t child : world.children(model)) visit(world, {child});
}

void AutoMap::add(std::uint16_t interf, std::size_t index, world::ModelRow model) {
  if (index >= kIndices) {
    ++left_out_;
    return;
  }
  out_.push_back({interf, static_cast<std::uint16_t>(index), model});
}

}  // namespace playhouse::drivers
