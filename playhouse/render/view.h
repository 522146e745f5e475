#pragma once

/// Views of pinhole cameras: projection, frustum culling, shadow frustum, and atlas packing.
/// Pure functions. Frames: W world, C camera (x along the optical axis, y left, z up), E the
/// axes of W with the eye as origin, so that single precision suffices far from W's origin.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/geom/orientation.h"

namespace playhouse::render {

inline constexpr std::uint32_t kNoGroup = 0xffffffff;

/// Content of a picture's pixels.
enum class Shows : std::uint8_t { kColor, kDepth, kSegments };

struct View {
  Shows shows = Shows::kColor;
  geom::Vec3 eye;  // m, in W
  geom::Quaternion q_WC;
  double half_width = 1, half_height = 1;  // of the image plane at distance 1
  double near = 0.1, far = 100;            // m along the optical axis; near and far planes
  std::uint32_t width = 0, height = 0;     // px
  std::uint32_t hides = kNoGroup;          // instances of this group are hidden
};

/// Column-major.
using Matrix = std::array<float, 16>;

/// Axes of C in W.
struct Axes {
  geom::Vec3 ahead, left, up;
};
Axes axes_of(const geom::Quaternion& q_WC);

/// Projection from E to clip coordinates: reversed depth, 1 at `near`, 0 at `far`.
Matrix clip_from_eye(const View& view, const Axes& axes);

/// Distance in m along the optical axis, from a depth value
/// of clip_from_eye(); 0 for the value 0, which means no hit.
double depth_of(float value, const View& view);

/// View frustum: six half-spaces, n p + d >= 0 inside, in E.
struct Planes {
  struct Plane {
    geom::Vec3 n;
    double d = 0;
  };
  std::array<Plane, 6> planes;
  bool may_show(const geom::Vec3& p_E, double radius) const {
    for (const Plane& plane : planes)
      if (dot(plane.n, p_E) + plane.d < -radius) return false;
    return true;
  }
};
Planes planes_of(const View& view, const Axes& axes);

/// Shadow frustum: the part of a view up to `reach` in light space, an oriented box.
struct SunBox {
  Axes axes;             // `ahead` is the direction of light
  geom::Vec3 low, high;  // m, along ahead, left and up, in E
  bool may_shade(const geom::Vec3& p_E, double radius) const {
    const double left = dot(axes.left, p_E), up = dot(axes.up, p_E);
    return left > low.y - radius && left < high.y + radius && up > low.z - radius && up < high.z + radius &&
           dot(axes.ahead, p_E) < high.x + radius;
  }
};
SunBox sun_box(const View& view, const Axes& axes, const geom::Vec3& to_sun, double reach);
/// Projection from E to clip coordinates of the shadow map: depth 0 nearest to the sun, 1 farthest.
Matrix clip_from_eye(const SunBox& box);

/// Placement of pictures on pages of at most `width` x `height`.
struct PageSlot {
  std::uint32_t page = 0, x = 0, y = 0;  // px
};
struct PictureSize {
  std::uint32_t width = 0, height = 0;  // px
};
/// Shelf packing, from the bottom row. A picture larger than a page gets a page of its own.
std::vector<PageSlot> pack(std::span<const PictureSize> pictures, PictureSize page);

}  // namespace playhouse::render
