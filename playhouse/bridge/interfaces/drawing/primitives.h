#pragma once

/// What clients draw, made of points, lines and triangles. Shapes with a corner that is not finite, or farther
/// than kFarthest, are left out, and so is what lacks corners.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/geom/orientation.h"

namespace playhouse::drivers {

/// Shapes of one kind, whose corners follow each other.
struct Primitives {
  std::size_t corners = 1;         // of each shape: 1, a point; 2, a line; 3, a triangle
  std::vector<geom::Vec3> points;  // m
};

/// From an axis to a corner, so that a whole number of mm fits into 32 bits. [m]
inline constexpr double kFarthest = 1e6;

/// The shapes of a mode of drawing (wire::graphics3d::kDrawPoints and so on); none: there is no such mode.
/// Quadrangles and polygons are fans about their first corner, as convex ones may be.
std::optional<Primitives> primitives_of(std::uint32_t mode, std::span<const geom::Vec3> points);

/// The even-odd inside of an outline at a height. One of more than kFilledExactly corners is a fan about the
/// first one.
Primitives filled(std::span<const geom::Vec2> outline, double height);
/// The time for it, of a thread that serves all clients, and what comes out grow with the square: n corners that cross
/// each other everywhere make n^2 / 4 trapezoids at most, half as much again as a drawing has room for.
inline constexpr std::size_t kFilledExactly = 128;

}  // namespace playhouse::drivers
