#pragma once

/// What cameras are told about where to look, and their images as bytes. Thread: the tick thread, between
/// steps.

#include <cstdint>
#include <span>
#include <vector>

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

/// How many bytes a pixel of such an image has.
std::size_t bytes_per_pixel(scene::ImageKind image);

/// Pixels one after the other: red, green, blue; brightness; ids plus 1 with the high byte first, as if they
/// were colours; or distances [mm] with the low byte first, as they are in the memory of most clients.
std::vector<std::uint8_t> image_bytes(scene::ImageKind image, std::span<const Pixel> pixels);

}  // namespace playhouse::world
