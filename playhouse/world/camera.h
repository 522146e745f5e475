#pragma once

/// What cameras are told about where to look. Thread: the tick thread, between steps.

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Where a camera shall look: to the left, up, and its horizontal field of view. [rad]
struct Aim {
  double pan = 0, tilt = 0, zoom = 0;
};

/// Goes there, as near as the limits of its words let it; it moves while somebody subscribes it. A zoom of 0
/// or less changes nothing. False, and nothing is changed, if a number is not finite.
bool aim_camera(World& world, CameraRow camera, const Aim& aim);

/// Turns so fast, no faster than it can, until it is told otherwise. [rad/s] False as above.
bool turn_camera(World& world, CameraRow camera, double pan_speed, double tilt_speed);

/// What commands mean from now on; a change stops it. kVelocity and kPosition alone.
void set_camera_mode(World& world, CameraRow camera, ControlMode mode);

}  // namespace playhouse::world
