#pragma once

/// AutoMap: which devices a world has when nobody wrote a .cfg file: those of every robot, on one port.

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

/// A device to be: an address within its port, and the model behind it (none for simulation:0).
struct MappedDevice {
  std::uint16_t interf = 0;
  std::uint16_t index = 0;
  world::ModelRow model;
  friend bool operator==(const MappedDevice&, const MappedDevice&) = default;
};

/// Models that are no part of another, ascending.
std::vector<world::ModelRow> top_models(const world::World& world);

/// Gives addresses. What comes later in a run gets what nobody had before; once an interface has no more of
/// that, what retired first (RetiredIndices).
/// Interfaces and the ways in which their indices count are those of kinds/:
///   one    0, of the whole world
///   robot  the number of the robot, a top-level position model, for the first of its models with this
///          interface; all others get the indices behind the last robot
///   count  the next index, over all models
class AutoMap {
 public:
  static constexpr std::size_t kIndices = 65536;  // of one interface on one port

  explicit AutoMap(std::size_t indices = kIndices) : indices_(indices) {}

  /// Devices of the world as it is, in the order in which clients list them: those of the whole world, of
  /// each robot model by model, of the same of models that no robot carries, and lasers and sonars that have
  /// no robot's number. A robot without a laser leaves the laser of its number free.
  std::vector<MappedDevice> of_world(const world::World& world);

  /// In the same order, those of some trees, whose tops are given in ascending order (top_models() has all).
  /// A robot gets the next number that neither a robot nor a further laser, sonar or position model has had,
  /// or one that none of them has any more.
  std::vector<MappedDevice> of_trees(const world::World& world, std::span<const world::ModelRow> tops);

  /// A device that it gave went at `time` [s], and one that went came back with its model.
  void retire(const MappedDevice& device, double time);
  void come_back(const MappedDevice& device);
  /// The run was taken back to `time` [s].
  void go_back(double time);

  /// Devices so far that got no index, as an interface has 65536 of them and none was free.
  std::size_t left_out() const { return left_out_; }

 private:
  using Found = std::pair<std::uint16_t, world::ModelRow>;

  std::size_t next_robot(double time);
  std::size_t next_index(std::uint16_t interf, double time);
  void map_tree(const world::World& world, world::ModelRow top, std::optional<std::size_t> robot);
  void visit(const world::World& world, world::ModelRow model);
  void add(std::uint16_t interf, std::size_t index, world::ModelRow model);

  const std::size_t indices_;                  // of each interface
  std::map<std::uint16_t, std::size_t> next_;  // the first index of an interface that nobody has had
  /// By interface. Those whose indices are the robots' numbers have one for all: a number is free where it is
  /// free in all of them.
  std::map<std::uint16_t, RetiredIndices> retired_;
  std::size_t left_out_ = 0;

  // While devices are mapped.
  std::vector<MappedDevice> out_;
  std::vector<Found> further_;        // wait for an index behind those of the robots
  std::optional<std::size_t> robot_;  // number of the one that is visited
  std::set<std::uint16_t> numbered_;  // interfaces in which it has its number
};

}  // namespace playhouse::drivers
