#include "playhouse/run/velocity_command.h"

namespace playhouse::run {

Change velocity_command(world::ModelId robot, const geom::Twist& velocity) {
  return [=](world::World& world) {
    if (const world::PositionRow row = world.position(robot)) world::command_velocity(world, row, velocity);
  };
}

}  // namespace playhouse::run
