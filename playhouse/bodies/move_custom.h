#pragma once

/// CustomMove: kinematics of a custom model, by the velocity
/// that its library sets (motion.h). Rows are of world::Customs.
///
/// In: a pose and a velocity.
/// Out: the pose after a time.
/// Cost: a rotation.

#include <cmath>

#include "playhouse/bodies/move_position.h"

namespace playhouse::bodies {

struct CustomMove {
  static const geom::Twist& velocity_of(const world::World& world, world::CustomRow custom) {
    return world.customs.velocity[custom];
  }
  static bool is_moving(const world::World& world, world::CustomRow custom) {
    return velocity_of(world, custom) != geom::Twist{};
  }
  static bool changes_height(const world::World& world, world::CustomRow custom) {
    return velocity_of(world, custom).z != 0;
  }
  static double turn_rate(const world::World& world, world::CustomRow custom) {
    return std::fabs(velocity_of(world, custom).a);
  }
  /// The linear speed of a point due to the rotation about the model's frame. [m/s]
  static double swing(const world::World& world, world::CustomRow custom, geom::Vec2 p_W) {
    const geom::Vec2 arm = p_W - world.models.X_WM[world.customs.model[custom]].xy();
    return turn_rate(world, custom) * std::sqrt(geom::dot(arm, arm));
  }
  static geom::Pose after(const world::World& world, world::CustomRow custom, const geom::Pose& X_PM,
                          double dt) {
    const geom::Twist& velocity = velocity_of(world, custom);
    geom::Pose X = driven(X_PM, velocity, dt);
    X.z += velocity.z * dt;
    return X;
  }
  static void stall(world::World& world, world::CustomRow custom, bool stalls) {
    world.customs.stall[custom] = stalls;
  }
  static void arrive(world::World&, world::CustomRow) {}
};

}  // namespace playhouse::bodies
