#pragma once

/// Overlap tests of polygons, with a tolerance: polygons that touch, or penetrate by less
/// than kTouch, do not overlap. Polygons are closed, simple, counter-clockwise and solid.
///
/// In: polygons in one frame.
/// Out: whether they overlap or touch; lengths inside. [m]
/// Cost: the product of their numbers of corners; with a concave polygon, times the cuts of an edge with
///   it.

#include <span>

#include "playhouse/geom/pose.h"

namespace playhouse::bodies {

inline constexpr double kTouch = 1e-6;  // m

/// A polygon with its convexity and mean vertex.
struct Polygon {
  std::span<const geom::Vec2> p;
  geom::Vec2 center;
  bool convex = false;
};

/// True if the counter-clockwise polygon turns left at every corner and has winding number 1.
bool is_convex(std::span<const geom::Vec2> polygon);

/// True if the ray from p along +x crosses the segment a-b: of closed loops, an odd number of times from
/// within.
inline bool ray_crosses(geom::Vec2 p, geom::Vec2 a, geom::Vec2 b) {
  return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y));
}

/// Length of the part of the segment a-b that is inside the polygon by more than kTouch. [m]
double length_inside(const Polygon& polygon, geom::Vec2 a, geom::Vec2 b);

/// Distance of p from the segment a-b. [m]
double distance_to_segment(geom::Vec2 p, geom::Vec2 a, geom::Vec2 b);

/// True if p is inside the polygon by more than kTouch.
bool is_inside(const Polygon& polygon, geom::Vec2 p);

/// True if the interiors intersect, also if one polygon contains
/// the other; of two that coincide only if both are convex.
bool overlap(const Polygon& first, const Polygon& second);

/// True if the polygons touch or overlap: their outlines come
/// within kTouch of each other, or one contains the other.
bool touch(std::span<const geom::Vec2> first, std::span<const geom::Vec2> second);

}  // namespace playhouse::bodies
