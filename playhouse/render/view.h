#pragma once

/// What a picture shows: where a pinhole camera is, and what falls into its view; and what its sun shines on.
/// Pure functions. Frames: W world, C camera (x the way it looks, y left, z up), E the axes of W about the
/// eye, so that single precision is enough far from W's origin.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/geom/orientation.h"

namespace playhouse::render {

inline constexpr std::uint32_t kNoGroup = 0xffffffff;

/// What the pixels of a picture are.
enum class Shows : std::uint8_t { kColor, kDepth, kSegments };

struct View {
  Shows shows = Shows::kColor;
  geom::Vec3 eye;  // m, in W
  geom::Quaternion q_WC;
  double half_width = 1, half_height = 1;  // of the picture at a distance of 1
  double near = 0.1, far = 100;            // m along the way it looks; only what is between is shown
  std::uint32_t width = 0, height = 0;     // px
  std::uint32_t hides = kNoGroup;          // instances of this group are not shown
};

/// Column by column, as OpenGL has it.
using Matrix = std::array<float, 16>;

/// Axes of C in W.
struct Axes {
  geom::Vec3 ahead, left, up;
};
Axes axes_of(const geom::Quaternion& q_WC);

/// From E to clip coordinates: depth 1 at `near`, 0 at `far`.
Matrix clip_from_eye(const View& view, const Axes& axes);

/// m along the way it looks, of a value that clip_from_eye() gives; 0 of the value 0, which stands for
/// nothing.
double depth_of(float value, const View& view);

/// Six half-spaces: n p + d >= 0 inside, in E.
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

/// The part of a view, up to `reach`, as the sun sees it: a box along its light.
struct SunBox {
  Axes axes;             // `ahead` is where the light goes
  geom::Vec3 low, high;  // m, along ahead, left and up, in E
  bool may_shade(const geom::Vec3& p_E, double radius) const {
    const double left = dot(axes.left, p_E), up = dot(axes.up, p_E);
    return left > low.y - radius && left < high.y + radius && up > low.z - radius && up < high.z + radius &&
           dot(axes.ahead, p_E) < high.x + radius;
  }
};
SunBox sun_box(const View& view, const Axes& axes, const geom::Vec3& to_sun, double reach);
/// From E to clip coordinates of the shadow map: depth 0 at the side of the sun, 1 at the other.
Matrix clip_from_eye(const SunBox& box);

/// Where pictures are on pages, each no wider than `width` and no higher than `height`.
struct Place {
  std::uint32_t page = 0, x = 0, y = 0;  // px
};
struct Sizes {
  std::uint32_t width = 0, height = 0;  // px
};
/// In shelves, from the lowest row on. Pictures larger than a page are alone on one.
std::vector<Place> pack(std::span<const Sizes> pictures, Sizes page);

}  // namespace playhouse::render
