#pragma once

/// AutoMap: assigns device addresses to a world without a .cfg file: all devices of all robots, on one port.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "playhouse/drivers/simulated/retired_indices.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// An address within the port, and its model (none for simulation:0).
struct MappedDevice {
  std::uint16_t interf = 0;
  std::uint16_t index = 0;
  world::ModelRow model;
  friend bool operator==(const MappedDevice&, const MappedDevice&) = default;
};

/// The roots, ascending.
std::vector<world::ModelRow> top_models(const world::World& world);

/// Address allocator. Later models get indices that were never used; once an interface has none left, the
/// index that retired first (RetiredIndices).
/// How an interface counts its indices is defined in kinds/:
///   one    0, of the whole world
///   robot  the number of the robot (a root position model) for the first of its models with this
///          interface; others get indices behind the last robot
///   count  the next index, over all models
class AutoMap {
 public:
  static constexpr std::size_t kIndices = 65536;  // of one interface on one port

  explicit AutoMap(std::size_t indices = kIndices) : indices_(indices) {}

  /// The devices of the present world, in the order in which clients list them: of the whole
  /// world, of each robot model by model, of models without a robot, and further lasers and
  /// sonars. A robot without a laser leaves the laser index of its number unused.
  std::vector<MappedDevice> of_world(const world::World& world);

  /// The devices of some trees in the same order; roots are given ascending
  /// (top_models() has all). A robot gets the next number that no robot,
  /// further laser, sonar or position model has had, or a retired one.
  std::vector<MappedDevice> of_trees(const world::World& world, std::span<const world::ModelRow> tops);

  /// A device was removed at `time` [s]; a removed device came back with its model.
  void retire(const MappedDevice& device, double time);
  void come_back(const MappedDevice& device);
  /// The run was rewound to `time` [s].
  void rewind_to(double time);

  /// Number of devices without an index: an interface has 65536 of them and none was free.
  std::size_t left_out() const { return left_out_; }

 private:
  using Found = std::pair<std::uint16_t, world::ModelRow>;

  std::size_t next_robot(double time);
  std::size_t next_index(std::uint16_t interf, double time);
  void map_tree(const world::World& world, world::ModelRow top, std::optional<std::size_t> robot);
  void visit(const world::World& world, world::ModelRow model);
  void add(std::uint16_t interf, std::size_t index, world::ModelRow model);

  const std::size_t indices_;                  // of each interface
  std::map<std::uint16_t, std::size_t> next_;  // first index never used, by interface
  /// By interface. Interfaces indexed by robot numbers share one
  /// entry: a number is free only if it is free in all of them.
  std::map<std::uint16_t, RetiredIndices> retired_;
  std::size_t left_out_ = 0;

  // Valid during a call that maps devices.
  std::vector<MappedDevice> out_;
  std::vector<Found> further_;        // to be indexed behind the robots
  std::optional<std::size_t> robot_;  // number of the current robot
  std::set<std::uint16_t> numbered_;  // interfaces that have used it
};

}  // namespace playhouse::drivers
