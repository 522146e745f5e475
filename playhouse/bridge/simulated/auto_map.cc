#include "playhouse/bridge/simulated/auto_map.h"

#include <algorithm>

#include "playhouse/bridge/simulated/model_interfaces.h"

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
  for (const world::ModelRow row : world.models.rows())
    if (world.models.root[row] == row) tops.push_back({row});
  return tops;
}

std::vector<MappedDevice> AutoMap::of_world(const world::World& world) {
  add_world(0);
  return of_trees(world, top_models(world));
}

std::vector<MappedDevice> AutoMap::of_trees(const world::World& world,
                                            std::span<const world::ModelRow> tops) {
  // Robot numbers first: further devices are indexed behind them.
  std::vector<std::pair<world::ModelRow, FreeNumber>> robots;
  for (const world::ModelRow top : tops)
    if (is_robot(world, top)) robots.emplace_back(top, next_robot(world.time()));
  for (const auto& [top, number] : robots) map_tree(world, top, true, number);
  for (const world::ModelRow top : tops)
    if (!is_robot(world, top)) map_tree(world, top, false, std::nullopt);
  for (const auto& [interf, model] : std::exchange(further_, {}))
    add(interf, next_number(interf, world.time()), model);
  return std::exchange(out_, {});
}

AutoMap::FreeNumber AutoMap::next_robot(double time) {
  std::size_t next = 0;
  each_numbered([&](std::uint16_t interf) { next = std::max(next, next_[interf]); });
  const FreeNumber number = has_room_for(next) ? next : beyond_ports(kNumbers, next, time);
  // Numbers that only some of these interfaces have used are no robot's any more.
  const std::size_t after = number == next ? next + 1 : next;
  each_numbered([&](std::uint16_t interf) { next_[interf] = after; });
  return number;
}

AutoMap::FreeNumber AutoMap::next_number(std::uint16_t interf, double time) {
  std::size_t& next = next_[interf];
  const FreeNumber number = has_room_for(next) ? next : beyond_ports(place_of(interf), next, time);
  if (number == next) ++next;
  return number;
}

AutoMap::FreeNumber AutoMap::beyond_ports(std::uint16_t place, std::size_t next, double time) {
  RetiredIndices& retired = retired_[place];
  if (const FreeNumber rested = retired.take(time)) return rested;
  if (retired.size() > indices_) return std::nullopt;
  has_all_ports_ = has_all_ports_ || ports_ == kPorts || !open_port_(ports_);
  if (has_all_ports_) return std::nullopt;
  add_world(ports_++);
  return next;
}

/// First of its port, so that every client's list has it.
void AutoMap::add_world(std::size_t port) {
  for (const KindInterface& each : scene::world_kind().interfaces) add(each.code, port * indices_, {});
}

void AutoMap::map_tree(const world::World& world, world::ModelRow top, bool is_robot, FreeNumber number) {
  is_robot_ = is_robot;
  robot_ = number;
  numbered_.clear();
  visit(world, top);
}

void AutoMap::visit(const world::World& world, world::ModelRow model) {
  const KindInterface* const own = interfaces_of(world, model).data();
  each_interface(world, model, [&](const KindInterface& each) {
    if (!has(world, model, each.listed)) return;
    const bool is_its_own = &each == own;
    if (each.index == Index::kRobot && is_robot_ && numbered_.insert(each.code).second) {
      add(each.code, robot_, model);
    } else if (each.index == Index::kCount || is_its_own) {
      add(each.code, next_number(each.code, world.time()), model);
    } else {
      further_.emplace_back(each.code, model);
    }
  });
  for (const world::ModelRow child : world.children(model)) visit(world, {child});
}

void AutoMap::add(std::uint16_t interf, FreeNumber number, world::ModelRow model) {
  if (!number) {
    ++left_out_;
    return;
  }
  if (model) retired_[place_of(interf)].hold(*number);
  out_.push_back({interf, static_cast<std::uint16_t>(*number % indices_), model,
                  static_cast<std::uint16_t>(*number / indices_)});
}

void AutoMap::retire(const MappedDevice& device, double time) {
  retired_[place_of(device.interf)].release(number_of(device), time);
}

void AutoMap::come_back(const MappedDevice& device) {
  retired_[place_of(device.interf)].hold(number_of(device));
}

void AutoMap::rewind_to(double time) {
  for (auto& [place, indices] : retired_) indices.rewind_to(time);
}

}  // namespace playhouse::drivers
