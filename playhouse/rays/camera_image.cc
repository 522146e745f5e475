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

/// 0, no depth, also beyond what a pixel holds.
std::uint32_t millimetres(double far, double noise, Rng& rng) {
  double depth = 1000 * far;
  if (noise > 0 && depth > 0) depth = std::max(0.0, depth + depth * noise * rng.gaussian());
  return depth > kDepthMost ? 0 : static_cast<std::uint32_t>(std::lround(depth));
}

std::uint32_t noisy_color(std::uint32_t rgb, double deviation, Rng& rng) {
  std::uint32_t noisy = 0;
  for (const int shift : {16, 8, 0}) noisy |= with_noise(rgb >> shift & 0xff, deviation, 255, rng) << shift;
  return noisy;
}

}  // namespace

std::uint32_t sky_color(const scene::WorldDesc& world) {
  const scene::Color sky{static_cast<float>(world.sky_red), static_cast<float>(world.sky_green),
                         static_cast<float>(world.sky_blue), 1};
  return scene::rgba8(sky) >> 8;
}

void expose(world::World& world, world::CameraRow camera, std::uint64_t tick, const Seen& seen) {
  const world::ModelRow model = world.cameras.model[camera];
  const scene::CameraDesc& desc = *world.desc(model).camera;
  std::vector<world::Pixel>& pixels = world.cameras.pixels[camera];
  pixels.resize(scene::pixels_of(desc));
  Rng rng(world.seed(), tick, {Purpose::kPixel, world.serial(model)});
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

}  // namespace playhouse::rays
