#pragma once

/// AutoMap: assigns device addresses to a world without a .cfg file: all devices of all robots. What has no
/// index left on a port continues on the following one.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "playhouse/bridge/simulated/retired_indices.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// An address, and its model (none for simulation:0).
struct MappedDevice {
  std::uint16_t interf = 0;
  std::uint16_t index = 0;
  world::ModelRow model;
  std::uint16_t port = 0;  // 0: the first one, 1: the following one
  friend bool operator==(const MappedDevice&, const MappedDevice&) = default;
};

/// The roots, ascending.
std::vector<world::ModelRow> top_models(const world::World& world);

/// Address allocator. An interface counts its numbers over all ports: number n is index n % indices of port
/// n / indices. Later models get numbers that were never used; once no port has one left, the number that
/// retired first (RetiredIndices), and if none has rested, one of a further port, or none while more than
/// a port's numbers rest: else few robots that come and go would open port after port.
/// How an interface counts its numbers is defined in kinds/:
///   one    0 of every port, of the whole world
///   robot  the number of the robot (a root position model) for the first of its models with this
///          interface; others get indices behind the last robot
///   count  the next index, over all models
class AutoMap {
 public:
  static constexpr std::size_t kIndices = 65536;  // of one interface on one port
  static constexpr std::size_t kPorts = 64;       // enough for limits::kModels

  /// Opens a following port, from 1 on; false if that is impossible. It is not asked again then.
  using OpenPort = std::function<bool(std::size_t port)>;

  explicit AutoMap(
      std::size_t indices = kIndices, OpenPort open_port = [](std::size_t) { return true; })
      : indices_(indices), open_port_(std::move(open_port)) {}

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

  /// Of each interface on each port.
  std::size_t indices() const { return indices_; }
  /// Number of ports in use.
  std::size_t ports() const { return ports_; }
  /// Number of devices without an address: no index was free, and there was no further port.
  std::size_t left_out() const { return left_out_; }

 private:
  using FoundDevice = std::pair<std::uint16_t, world::ModelRow>;
  using FreeNumber = std::optional<std::size_t>;  // none: there is none left

  FreeNumber next_robot(double time);
  FreeNumber next_number(std::uint16_t interf, double time);
  /// A retired number, or `next` once a further port has it; none while more numbers rest than a port has.
  FreeNumber beyond_ports(std::uint16_t place, std::size_t next, double time);
  bool has_room_for(std::size_t number) const { return number < ports_ * indices_; }
  void add_world(std::size_t port);
  void map_tree(const world::World& world, world::ModelRow top, bool is_robot, FreeNumber number);
  void visit(const world::World& world, world::ModelRow model);
  void add(std::uint16_t interf, FreeNumber number, world::ModelRow model);
  std::size_t number_of(const MappedDevice& device) const { return device.port * indices_ + device.index; }

  const std::size_t indices_;  // of each interface on each port
  const OpenPort open_port_;
  std::size_t ports_ = 1;
  bool has_all_ports_ = false;                 // no further one can be opened
  std::map<std::uint16_t, std::size_t> next_;  // first number never used, by interface
  /// By interface. Interfaces indexed by robot numbers share one
  /// entry: a number is free only if it is free in all of them.
  std::map<std::uint16_t, RetiredIndices> retired_;
  std::size_t left_out_ = 0;

  // Valid during a call that maps devices.
  std::vector<MappedDevice> out_;
  std::vector<FoundDevice> further_;  // to be indexed behind the robots
  bool is_robot_ = false;             // the current tree
  FreeNumber robot_;                  // its number
  std::set<std::uint16_t> numbered_;  // interfaces that have used it
};

}  // namespace playhouse::drivers
