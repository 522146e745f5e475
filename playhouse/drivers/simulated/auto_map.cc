#include "playhouse/drivers/simulated/auto_map.h"

#include <algorithm>

#include "playhouse/drivers/simulated/model_interfaces.h"

namespace playhouse::drivers {
namespace {

using scene::Index;
using scene::KindInterface;

/// Calls visit(code) for every interface indexed by robot numbers.
template <typename Visit>
void each_numbered(const Visit& visit) {
  for (const scene::Kind& kind : scene::kinds()) {
    for (const KindInterface& each : kind.interfaces)
      if (kind.simulated && each.index == Index::kRobot) visit(each.code);
  }
}

constexpr std::uint16_t kNumbers = 0;  // not a valid code

/// Pool of retired indices for an interface: its code, or kNumbers.
std::uint16_t place_of(std::uint16_t interf) {
  std::uint16_t place = interf;
  each_numbered([&](std::uint16_t numbered) {
    if (numbered == interf) place = kNumbers;
  });
  return place;
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
  // Robot numbers first: further devices are indexed behind them.
  std::vector<std::pair<world::ModelRow, std::size_t>> robots;
  for (const world::ModelRow top : tops)
    if (is_robot(world, top)) robots.emplace_back(top, next_robot(world.time()));
  for (const auto& [top, number] : robots) map_tree(world, top, number);
  for (const world::ModelRow top : tops)
    if (!is_robot(world, top)) map_tree(world, top, std::nullopt);
  for (const auto& [interf, model] : std::exchange(further_, {}))
    add(interf, next_index(interf, world.time()), model);
  return std::exchange(out_, {});
}

/// indices_ if there is none left.
std::size_t AutoMap::next_robot(double time) {
  std::size_t number = 0;
  each_numbered([&](std::uint16_t interf) { number = std::max(number, next_[interf]); });
  each_numbered([&](std::uint16_t interf) { next_[interf] = std::min(number + 1, indices_); });
  return number < indices_ ? number : retired_[kNumbers].take(time).value_or(indices_);
}

/// indices_ if there is none left.
std::size_t AutoMap::next_index(std::uint16_t interf, double time) {
  std::size_t& next = next_[interf];
  return next < indices_ ? next++ : retired_[place_of(interf)].take(time).value_or(indices_);
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
      add(each.code, next_index(each.code, world.time()), model);
    } else {
      further_.emplace_back(each.code, model);
    }
  });
  for (const std::uint32_t child : world.children(model)) visit(world, {child});
}

void AutoMap::add(std::uint16_t interf, std::size_t index, world::ModelRow model) {
  if (index >= indices_) {
    ++left_out_;
    return;
  }
  if (model) retired_[place_of(interf)].hold(index);
  out_.push_back({interf, static_cast<std::uint16_t>(index), model});
}

void AutoMap::retire(const MappedDevice& device, double time) {
  retired_[place_of(device.interf)].release(device.index, time);
}

void AutoMap::come_back(const MappedDevice& device) {
  retired_[place_of(device.interf)].hold(device.index);
}

void AutoMap::rewind_to(double time) {
  for (auto& [place, indices] : retired_) indices.rewind_to(time);
}

}  // namespace playhouse::drivers
