#pragma once

/// PositionMove: kinematics of a robot base (motion.h). Rows are of world::Positions.
///
/// In: a pose, and a velocity in its frame.
/// Out: the pose after a time; odometry.
/// Cost: a rotation.

#include <cmath>

#include "playhouse/world/world.h"

namespace playhouse::bodies {

/// Explicit Euler step over `dt`: translates along the initial heading, then turns.
inline geom::Pose driven(const geom::Pose& X_PM, const geom::Twist& velocity, double dt) {
  const geom::Vec2 p = geom::Rotation::of(X_PM.a) * geom::Vec2{velocity.x * dt, velocity.y * dt};
  return {X_PM.x + p.x, X_PM.y + p.y, X_PM.z, geom::normalize(X_PM.a + velocity.a * dt)};
}

struct PositionMove {
  static bool is_moving(const world::World& world, world::PositionRow robot) {
    const geom::Twist& velocity = world.positions.velocity[robot];
    return velocity.x != 0 || velocity.y != 0 || velocity.a != 0;
  }
  static bool changes_height(const world::World&, world::PositionRow) { return false; }
  static double turn_rate(const world::World& world, world::PositionRow robot) {
    return std::fabs(world.positions.velocity[robot].a);
  }
  /// Its base turns about its own frame.
  static double swing(const world::World&, world::PositionRow, geom::Vec2) { return 0; }
  static geom::Pose after(const world::World& world, world::PositionRow robot, const geom::Pose& X_PM,
                          double dt) {
    return driven(X_PM, world.positions.velocity[robot], dt);
  }
  static void stall(world::World& world, world::PositionRow robot, bool stalls) {
    world.positions.stall[robot] = stalls;
  }

  /// Updates odometry after a move. Wheels of a stalled robot do not turn, so it is not called for those.
  static void arrive(world::World& world, world::PositionRow robot) {
    world::Positions& positions = world.positions;
    const world::ModelRow model = positions.model[robot];
    if (world.desc(model).position->localization == scene::Localization::kGps) {
      const geom::Pose &X_WO = positions.X_WO[robot], &X_WM = world.models.X_WM[model];
      positions.X_OM[robot] = X_WO == geom::Pose{} ? X_WM : geom::compose(geom::inverse(X_WO), X_WM);
      return;
    }
    const geom::Twist &velocity = positions.velocity[robot], &error = positions.odom_error[robot];
    const geom::Twist believed{velocity.x * (1 + error.x), velocity.y * (1 + error.y), 0,
                               velocity.a * (1 + error.a)};
    positions.X_OM[robot] = driven(positions.X_OM[robot], believed, world.scene().interval);
  }
};

}  // namespace playhouse::bodies
