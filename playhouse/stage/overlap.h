#pragma once

/// Whether polygons overlap, exactly up to kTouch: bodies that touch, or reach into each other by less than
/// that, do not overlap. Polygons are closed, simple and counter-clockwise; what is inside them is solid.

#include <span>

#include "playhouse/geom/pose.h"

namespace playhouse::stage {

inline constexpr double kTouch = 1e-6;  // m

/// A polygon with what is known of its shape and its mean vertex.
struct Outline {
  std::span<const geom::Vec2> p;
  geom::Vec2 center;
  bool convex = false;
};

/// The length of the segment a-b that is inside the polygon by more than kTouch. [m]
double length_inside(const Outline& polygon, geom::Vec2 a, geom::Vec2 b);

/// How far p is from the segment a-b. [m]
double distance_to_segment(geom::Vec2 p, geom::Vec2 a, geom::Vec2 b);

/// True if p is inside the polygon by more than kTouch.
bool is_inside(const Outline& polygon, geom::Vec2 p);

/// True if the insides of the polygons meet. Also true for a polygon within another, and for two that
/// coincide when both are convex.
bool overlap(const Outline& first, const Outline& second);

/// True if the polygons touch or overlap: their outlines come within kTouch of each other, or one is within
/// the other.
bool touch(std::span<const geom::Vec2> first, std::span<const geom::Vec2> second);

}  // namespace playhouse::stage
