#pragma once

/// ActuatorMove: kinematics of an actuator and what it carries (motion.h). Rows are of world::Actuators.
///
/// In: position and velocity of a joint.
/// Out: the pose of what it moves, after a time; its new position.
/// Cost: a composition of poses.

#include <cmath>

#include "playhouse/scene/forms/actuator.h"
#include "playhouse/world/world.h"

namespace playhouse::bodies {

struct ActuatorMove {
  static const scene::ActuatorDesc& desc_of(const world::World& world, world::ActuatorRow actuator) {
    return *world.desc(world.actuators.model[actuator]).actuator;
  }
  static double position_after(const world::World& world, world::ActuatorRow actuator, double dt) {
    const world::Actuators& actuators = world.actuators;
    return scene::within_reach(desc_of(world, actuator),
                               actuators.position[actuator] + actuators.velocity[actuator] * dt);
  }

  static bool is_moving(const world::World& world, world::ActuatorRow actuator) {
    return world.actuators.velocity[actuator] != 0;
  }
  static bool changes_height(const world::World& world, world::ActuatorRow actuator) {
    const scene::ActuatorDesc& desc = desc_of(world, actuator);
    return is_moving(world, actuator) && desc.type == scene::ActuatorType::kLinear && desc.axis_z != 0;
  }
  static double turn_rate(const world::World& world, world::ActuatorRow actuator) {
    const bool turns = desc_of(world, actuator).type == scene::ActuatorType::kRotational;
    return turns ? std::fabs(world.actuators.velocity[actuator]) : 0;
  }
  /// The linear speed of a point due to the rotation, which matters for points far from the axis. [m/s]
  static double swing(const world::World& world, world::ActuatorRow actuator, geom::Vec2 p_W) {
    const geom::Vec2 arm = p_W - world.models.X_WM[world.actuators.model[actuator]].xy();
    return turn_rate(world, actuator) * std::sqrt(geom::dot(arm, arm));
  }
  static geom::Pose after(const world::World& world, world::ActuatorRow actuator, const geom::Pose& X_PM,
                          double dt) {
    if (!is_moving(world, actuator)) return X_PM;
    return geom::compose(world.actuators.X_PJ[actuator],
                         scene::way_along(desc_of(world, actuator), position_after(world, actuator, dt)));
  }
  static void stall(world::World& world, world::ActuatorRow actuator, bool stalls) {
    world.actuators.stall[actuator] = stalls;
  }
  static void arrive(world::World& world, world::ActuatorRow actuator) {
    world.actuators.position[actuator] = position_after(world, actuator, world.scene().interval);
  }
};

}  // namespace playhouse::bodies
