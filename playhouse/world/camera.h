#pragma once

/// Camera commands (pan, tilt, zoom) and conversion of
/// images to bytes. Thread: the tick thread, between steps.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Target of a camera: pan to the left, tilt up, horizontal field of view. [rad]
struct Aim {
  double pan = 0, tilt = 0, zoom = 0;
};

/// Position control: moves to the target, clamped to the camera's limits, while subscribed. A
/// zoom of 0 or less keeps the present one. False, without effect, if a number is not finite.
bool aim_camera(World& world, CameraRow camera, const Aim& aim);

/// Velocity control within the camera's limits, until the next command. [rad/s] False as above.
bool turn_camera(World& world, CameraRow camera, double pan_speed, double tilt_speed);

/// Sets the control mode; a change stops the camera. kVelocity and kPosition only.
void set_camera_mode(World& world, CameraRow camera, ControlMode mode);

/// Bytes per pixel of an image of this kind.
std::size_t bytes_per_pixel(scene::ImageKind image);

/// Pixel formats: RGB888; 8-bit brightness; segmentation: id + 1, big-endian,
/// like colours; depth [mm], little-endian, the byte order of most clients.
std::vector<std::uint8_t> image_bytes(scene::ImageKind image, std::span<const Pixel> pixels);

}  // namespace playhouse::world
