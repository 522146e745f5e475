#pragma once

/// What cameras of all engines share: the pose of the lens, background colours,
/// and images from the samples of pixels with the camera's errors applied.
///
/// In: what each pixel sees. Out: Cameras::pixels.
/// Cost: the pixels.
/// Source: brightness by ITU-R BT.601.

#include <cstdint>
#include <span>

#include "playhouse/world/world.h"

namespace playhouse::rays {

/// Background colour 0xRRGGBB, from a world file's `sky`.
std::uint32_t sky_color(const scene::WorldDesc& world);

/// Value of a pixel of a segmentation image that shows this model.
constexpr std::uint32_t segment_of(world::ModelId model) {
  return (model.value + 1) & 0xffffff;
}

/// Height of the lens above the frame of the camera's body: half the body's height.  [m]
inline double lens_height(const scene::ModelDesc& camera) {
  return 0.5 * camera.size.z;
}

/// Samples of a camera's pixels, row by row from the top.
struct Seen {
  std::span<const double> far;            // m of depth along the optical axis, 0: no hit. Depth images only
  std::span<const std::uint32_t> sample;  // 0xRRGGBB, or segment_of(). Other images
};

/// Writes the image of a camera, row `camera` of world::Cameras, with its noise at `tick`.
void expose(world::World& world, world::CameraRow camera, std::uint64_t tick, const Seen& seen);

/// True if it has two lenses, and somebody reads what both see.
bool takes_pairs(const world::World& world, world::CameraRow camera);
/// Writes what makes its image one of a pair: that of the right lens, and the depths of the left one. [m, 0: no hit]
void expose_pair(world::World& world, world::CameraRow camera, std::uint64_t tick, const Seen& right,
                 std::span<const double> left_far);
/// Leaves its image alone, as nobody reads pairs.
void forget_pair(world::World& world, world::CameraRow camera);

}  // namespace playhouse::rays
