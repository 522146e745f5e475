#include "playhouse/rays/camera_image.h"

#include <algorithm>
#include <cmath>

#include "playhouse/base/rng.h"
#include "playhouse/scene/forms/camera.h"
#include "playhouse/scene/forms/colors.h"

namespace playhouse::rays {
namespace {

using scene::ImageKind;

constexpr double kDepthMost = 65535;  // mm, largest value of a depth pixel

std::uint32_t brightness(std::uint32_t rgb) {
  return (299 * (rgb >> 16) + 587 * (rgb >> 8 & 0xff) + 114 * (rgb & 0xff) + 500) / 1000;
}

/// The value plus Gaussian noise, clamped to 0 .. most.
std::uint32_t with_noise(double value, double deviation, double most, Rng& rng) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(value + deviation * rng.gaussian(), 0.0, most)));
}

/// 0 stays 0.
double with_depth_noise(double depth, double noise, Rng& rng) {
  return noise > 0 && depth > 0 ? std::max(0.0, depth + depth * noise * rng.gaussian()) : depth;
}

/// 0, no depth, also beyond what a pixel holds.
std::uint32_t millimetres(double far, double noise, Rng& rng) {
  const double depth = with_depth_noise(1000 * far, noise, rng);
  return depth > kDepthMost ? 0 : static_cast<std::uint32_t>(std::lround(depth));
}

std::uint32_t noisy_color(std::uint32_t rgb, double deviation, Rng& rng) {
  std::uint32_t noisy = 0;
  for (const int shift : {16, 8, 0}) noisy |= with_noise(rgb >> shift & 0xff, deviation, 255, rng) << shift;
  return noisy;
}

/// What of a camera has noise of its own: the part of its stream.
enum CameraPart : std::uint32_t { kLeft, kRight, kDepths };

Rng noise_of(const world::World& world, world::CameraRow camera, std::uint64_t tick, CameraPart part) {
  return {world.seed(), tick, {Purpose::kPixel, world.serial(world.cameras.model[camera]), part}};
}

const scene::CameraDesc& camera_of(const world::World& world, world::CameraRow camera) {
  return *world.desc(world.cameras.model[camera]).camera;
}

/// An image from what its pixels see.
void develop(const world::World& world, world::CameraRow camera, std::uint64_t tick, CameraPart part,
             const Seen& seen, std::vector<world::Pixel>& pixels) {
  const scene::CameraDesc& desc = camera_of(world, camera);
  pixels.resize(scene::pixels_of(desc));
  Rng rng = noise_of(world, camera, tick, part);
  const double deviation = desc.image == ImageKind::kSegmentation ? 0 : 255 * desc.noise_value;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    std::uint32_t& sample = pixels[i].sample;
    if (desc.image == ImageKind::kDepth) {
      sample = millimetres(seen.far[i], desc.noise_depth, rng);
      continue;
    }
    sample = deviation > 0 ? noisy_color(seen.sample[i], deviation, rng) : seen.sample[i];
    if (desc.image == ImageKind::kGray) sample = brightness(sample);
  }
}

}  // namespace

std::uint32_t sky_color(const scene::WorldDesc& world) {
  const scene::Color sky{static_cast<float>(world.sky_red), static_cast<float>(world.sky_green),
                         static_cast<float>(world.sky_blue), 1};
  return scene::rgba8(sky) >> 8;
}

void expose(world::World& world, world::CameraRow camera, std::uint64_t tick, const Seen& seen) {
  develop(world, camera, tick, kLeft, seen, world.cameras.pixels[camera]);
}

bool takes_pairs(const world::World& world, world::CameraRow camera) {
  return world.cameras.stereo_open[camera] && camera_of(world, camera).baseline > 0;
}

void expose_pair(world::World& world, world::CameraRow camera, std::uint64_t tick, const Seen& right,
                 std::span<const double> left_far) {
  develop(world, camera, tick, kRight, right, world.cameras.right_pixels[camera]);
  const scene::CameraDesc& desc = camera_of(world, camera);
  // A depth image and the depths are one measurement.
  Rng rng = noise_of(world, camera, tick, desc.image == ImageKind::kDepth ? kLeft : kDepths);
  std::vector<float>& depths = world.cameras.depths[camera];
  depths.clear();
  for (const double far : left_far)
    depths.push_back(static_cast<float>(with_depth_noise(far, desc.noise_depth, rng)));
}

void forget_pair(world::World& world, world::CameraRow camera) {
  world.cameras.right_pixels[camera].clear();
  world.cameras.depths[camera].clear();
}

}  // namespace playhouse::rays
