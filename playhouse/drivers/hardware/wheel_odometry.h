#pragma once

/// Both ways between what wheels have turned and the pose of a robot: odometry of hardware that tells how far it has gone
/// since it told last, in a frame that clients set, and how far an odometry's robot has gone.

#include <cmath>
#include <optional>
#include <utility>

#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

/// On an arc.  [m, rad]
struct WheelStep {
  double distance = 0, turn = 0;
};

class WheelOdometry {
 public:
  void add(const WheelStep& step) {
    const double half = step.turn / 2;
    const double chord = std::fabs(half) < 1e-9 ? step.distance : step.distance * std::sin(half) / half;
    const geom::Vec2 p = geom::Rotation::of(X_OR_.a + half) * geom::Vec2{chord, 0};
    X_OR_ = {X_OR_.x + p.x, X_OR_.y + p.y, 0, geom::normalize(X_OR_.a + step.turn)};
  }
  /// Where the robot is now has this pose from now on.
  void set(const geom::Pose& pose) { X_OR_ = pose; }
  const geom::Pose& pose() const { return X_OR_; }

 private:
  geom::Pose X_OR_;
};

class WheelSteps {
 public:
  /// From the pose before to this one of an odometry; nothing at first, and at a jump.
  WheelStep to(const geom::Pose& X_OR) {
    const std::optional<geom::Pose> before = std::exchange(X_OR_, X_OR);
    if (!before) return {};
    const geom::Pose X = geom::compose(geom::inverse(*before), X_OR);
    if (!(std::hypot(X.x, X.y) < kJump)) return {};
    const double half = X.a / 2, chord = X.x * std::cos(half) + X.y * std::sin(half);
    return {std::fabs(half) < 1e-9 ? chord : chord * half / std::sin(half), X.a};
  }

 private:
  static constexpr double kJump = 1;  // m
  std::optional<geom::Pose> X_OR_;
};

}  // namespace playhouse::drivers
