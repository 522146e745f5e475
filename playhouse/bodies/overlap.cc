#include "playhouse/bodies/overlap.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace playhouse::bodies {
namespace {

using geom::Vec2;

constexpr double kLength = 1e-9;  // m; shorter pieces are rounding noise

double length(Vec2 v) {
  return std::sqrt(geom::dot(v, v));
}

Vec2 corner_after(std::span<const Vec2> polygon, std::size_t i) {
  return polygon[i + 1 < polygon.size() ? i + 1 : 0];
}

/// Clips the segment to [from, to] against each
/// edge, moved inwards by kTouch (Cyrus-Beck).
double length_inside_convex(std::span<const Vec2> polygon, Vec2 a, Vec2 b) {
  double from = 0, to = 1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 e = corner_after(polygon, i) - polygon[i];
    const double margin = kTouch * length(e);
    const double left_a = geom::cross(e, a - polygon[i]) - margin,
                 left_b = geom::cross(e, b - polygon[i]) - margin;
    if (left_a < 0 && left_b < 0) return 0;
    if (left_a >= 0 && left_b >= 0) continue;
    const double t = left_a / (left_a - left_b);
    (left_a < 0 ? from : to) = left_a < 0 ? std::max(from, t) : std::min(to, t);
  }
  return to > from ? (to - from) * length(b - a) : 0;
}

}  // namespace

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 e = b - a;
  const double squared = geom::dot(e, e);
  const double t = squared > 0 ? std::clamp(geom::dot(p - a, e) / squared, 0.0, 1.0) : 0;
  return length(p - (a + t * e));
}

namespace {

bool is_inside_any(std::span<const Vec2> polygon, Vec2 p) {
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = corner_after(polygon, i);
    if (distance_to_segment(p, a, b) <= kTouch) return false;
    if (ray_crosses(p, a, b)) odd = !odd;
  }
  return odd;
}

/// The parameter of the next intersection of the segment a-b with the outline after `from`; 1 if none.
double next_cut(std::span<const Vec2> polygon, Vec2 a, Vec2 b, double from) {
  const Vec2 d = b - a;
  double next = 1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 v = polygon[i], e = corner_after(polygon, i) - v;
    const double denominator = geom::cross(d, e);
    if (denominator == 0) continue;
    const double t = geom::cross(v - a, e) / denominator, s = geom::cross(v - a, d) / denominator;
    if (t > from && t < next && s >= 0 && s <= 1) next = t;
  }
  return next;
}

/// Sums the pieces between intersections whose midpoint is inside.
double length_inside_any(std::span<const Vec2> polygon, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  double inside = 0;
  for (double from = 0; from < 1;) {
    const double to = next_cut(polygon, a, b, from);
    if (is_inside_any(polygon, a + (0.5 * (from + to)) * d)) inside += to - from;
    from = to;
  }
  return inside * length(d);
}

bool outline_enters(const Polygon& polygon, const Polygon& other) {
  for (std::size_t i = 0; i < other.p.size(); ++i)
    if (length_inside(polygon, other.p[i], corner_after(other.p, i)) > kLength) return true;
  return false;
}

/// True if the segments a-b and c-d properly intersect.
bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto on_both_sides = [](Vec2 from, Vec2 to, Vec2 p, Vec2 q) {
    return (geom::cross(to - from, p - from) > 0) != (geom::cross(to - from, q - from) > 0);
  };
  return on_both_sides(a, b, c, d) && on_both_sides(c, d, a, b);
}

bool segments_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return cross_each_other(a, b, c, d) ||
         std::min(std::min(distance_to_segment(a, c, d), distance_to_segment(b, c, d)),
                  std::min(distance_to_segment(c, a, b), distance_to_segment(d, a, b))) <= kTouch;
}

}  // namespace

bool is_convex(std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  int upward_turns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = polygon[(i + 1) % n] - polygon[i];
    const Vec2 out = polygon[(i + 2) % n] - polygon[(i + 1) % n];
    if (geom::cross(in, out) < 0) return false;
    if (in.y < 0 && out.y >= 0) ++upward_turns;
  }
  return upward_turns <= 1;
}

double length_inside(const Polygon& polygon, Vec2 a, Vec2 b) {
  return polygon.convex ? length_inside_convex(polygon.p, a, b) : length_inside_any(polygon.p, a, b);
}

bool is_inside(const Polygon& polygon, Vec2 p) {
  return is_inside_any(polygon.p, p);
}

bool overlap(const Polygon& first, const Polygon& second) {
  return outline_enters(first, second) || outline_enters(second, first) ||
         (first.convex && is_inside(second, first.center)) ||
         (second.convex && is_inside(first, second.center));
}

bool touch(std::span<const Vec2> first, std::span<const Vec2> second) {
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t k = 0; k < second.size(); ++k)
      if (segments_meet(first[i], corner_after(first, i), second[k], corner_after(second, k))) return true;
  return is_inside_any(first, second[0]) || is_inside_any(second, first[0]);
}

}  // namespace playhouse::bodies
