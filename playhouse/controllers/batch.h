#pragma once

/// Batch: all robots that run one kind of controller, and what every batch needs to find its robots' parts.
/// Filled by attach() before the first tick. Thread: as world::Decider.

#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::controllers {

/// One `ctrl` line: who is to run what.
struct Post {
  world::ModelRow model;
  std::string name;  // of the controller
  std::vector<std::string> arguments;
  std::uint32_t order = 0;  // 0 for the model's first ctrl, 1 for its second, ...
};

class Batch : public world::Decider {
 public:
  /// Takes the model and subscribes what the controller uses. Fails (without "file:line") when the model
  /// lacks it.
  virtual Result<void> add(world::World& world, const Post& post) = 0;
};

/// Row of the model in the positions, or none if it does not drive.
world::PositionRow position_of(const world::World& world, world::ModelRow model);

/// The rangers of a robot, depth first, children in file order; its own row first if it is one itself.
std::vector<world::RangerRow> rangers_of(const world::World& world, world::ModelRow model);

/// Its fiducial finders, in the same order.
std::vector<world::FiducialRow> finders_of(const world::World& world, world::ModelRow model);

/// Bearings of all beams of a ranger in the frame of `robot`, in beam order. [rad]
std::vector<float> bearings_of(const world::World& world, world::ModelRow robot, world::RangerRow ranger);

/// The first beam of a ranger; its beams are one contiguous run.
std::uint32_t first_beam(const world::World& world, world::RangerRow ranger);
std::uint32_t beam_count(const world::World& world, world::RangerRow ranger);

inline void drive(world::World& world, world::PositionRow robot, double forward, double turn) {
  world.positions.mode[robot.index] = world::ControlMode::kVelocity;
  world.positions.command[robot.index] = {forward, 0, 0, turn};
}

}  // namespace playhouse::controllers
