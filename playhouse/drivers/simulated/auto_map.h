#pragma once

/// AutoMap: which devices a world has when nobody wrote a .cfg file: every robot, on one port.

#include <cstdint>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// A device to be: an address within its port, and the model behind it (none for simulation:0).
struct MappedDevice {
  std::uint16_t interf = 0;
  std::uint16_t index = 0;
  world::ModelRow model;
  friend bool operator==(const MappedDevice&, const MappedDevice&) = default;
};

/// In the order in which clients list them:
///   simulation:0
///   per robot k (a position model at the top of the scene, in the scene's order)
///     position2d:k
///     ranger:n    every ranger it carries, n counting over all robots
///     laser:k     its first ranger with a scanner     sonar:k   its first ranger with several sensors
///     fiducial:n  every finder it carries, n counting over all robots
///   the same of models that no robot carries
///   further lasers and sonars of a robot, from the first index behind the robots on
/// A robot without a laser leaves laser:k free. Indices beyond 65535 are left out; the caller can tell by
/// `left_out`.
struct AutoMap {
  std::vector<MappedDevice> devices;
  std::size_t robots = 0;
  std::size_t left_out = 0;
};
AutoMap auto_map(const world::World& world);

}  // namespace playhouse::drivers
