#include "playhouse/world/camera.h"

#include <algorithm>
#include <cmath>

namespace playhouse::world {
namespace {

const scene::CameraDesc& camera_of(const World& world, CameraRow camera) {
  return *world.desc(world.cameras.model[camera]).camera;
}

/// Clamps `wanted`.
double within(double wanted, double least, double most) {
  return std::max(least, std::min(wanted, most));
}

}  // namespace

bool aim_camera(World& world, CameraRow camera, const Aim& aim) {
  if (!std::isfinite(aim.pan) || !std::isfinite(aim.tilt) || !std::isfinite(aim.zoom)) return false;
  const scene::CameraDesc& desc = camera_of(world, camera);
  Cameras& cameras = world.cameras;
  cameras.goal_pan[camera] = within(aim.pan, desc.pan_min, desc.pan_max);
  cameras.goal_tilt[camera] = within(aim.tilt, desc.tilt_min, desc.tilt_max);
  if (aim.zoom > 0) cameras.goal_zoom[camera] = within(aim.zoom, desc.zoom_min, desc.zoom_max);
  return true;
}

bool turn_camera(World& world, CameraRow camera, double pan_speed, double tilt_speed) {
  if (!std::isfinite(pan_speed) || !std::isfinite(tilt_speed)) return false;
  world.cameras.command_pan[camera] = pan_speed;
  world.cameras.command_tilt[camera] = tilt_speed;
  return true;
}

void set_camera_mode(World& world, CameraRow camera, ControlMode mode) {
  Cameras& cameras = world.cameras;
  if (cameras.mode[camera] == mode) return;
  cameras.mode[camera] = mode;
  cameras.goal_pan[camera] = cameras.pan[camera];
  cameras.goal_tilt[camera] = cameras.tilt[camera];
  cameras.command_pan[camera] = cameras.command_tilt[camera] = 0;
}

std::size_t bytes_per_pixel(scene::ImageKind image) {
  switch (image) {
    case scene::ImageKind::kColor:
    case scene::ImageKind::kSegmentation:
      return 3;
    case scene::ImageKind::kDepth:
      return 2;
    case scene::ImageKind::kGray:
      break;
  }
  return 1;
}

std::vector<std::uint8_t> image_bytes(scene::ImageKind image, std::span<const Pixel> pixels) {
  const std::size_t size = bytes_per_pixel(image);
  const bool low_first = image == scene::ImageKind::kDepth;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(pixels.size() * size);
  for (const Pixel& pixel : pixels)
    for (std::size_t k = 0; k < size; ++k)
      bytes.push_back(static_cast<std::uint8_t>(pixel.sample >> 8 * (low_first ? k : size - 1 - k)));
  return bytes;
}

}  // namespace playhouse::world
