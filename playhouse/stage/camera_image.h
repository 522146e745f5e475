#pragma once

/// What is the same of the cameras of all engines: where a lens is, the colours of what is no body, and an
/// image of what its pixels see, with the camera's errors.
///
/// In: what pixels see. Out: Cameras::pixels.
/// Source: brightness by ITU-R BT.601.

#include <cstdint>
#include <span>

#include "playhouse/world/world.h"

namespace playhouse::stage {

/// 0xRRGGBB, of a world file's `sky`.
std::uint32_t sky_color(const scene::WorldDesc& world);

/// A pixel of an image of models that shows this one.
constexpr std::uint32_t segment_of(world::ModelId model) {
  return (model.value + 1) & 0xffffff;
}

/// How high the lens is above the frame of the camera's body: in the middle of it.  [m]
inline double lens_height(const scene::ModelDesc& camera) {
  return 0.5 * camera.size.z;
}

/// What the pixels of a camera see, row by row from the top.
struct Seen {
  std::span<const double> far;            // m along the way it looks, 0: nothing. Of images of distances
  std::span<const std::uint32_t> sample;  // 0xRRGGBB, or segment_of(). Of all other images
};

/// Makes the image of a camera, row `camera` of world::Cameras, as it tells it at `tick`.
void expose(world::World& world, std::uint32_t camera, std::uint64_t tick, const Seen& seen);

}  // namespace playhouse::stage
