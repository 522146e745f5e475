#pragma once

/// Points and poses of the 2.5-D world: x forward, y left, z up; headings counter-clockwise about z, in (-pi,
/// pi]. X_AB is the pose of frame B in A, p_AP a point in A; compose(X_AB, X_BC) is X_AC. Metres and radians.

#include <algorithm>
#include <utility>

#include "playhouse/geom/trig.h"

namespace playhouse::geom {

struct Vec2 {
  double x = 0, y = 0;

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

struct Pose {
  double x = 0, y = 0, z = 0;  // m
  double a = 0;                // rad

  constexpr Vec2 xy() const { return {x, y}; }
  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

/// Velocity or displacement in a body's own frame. [m/s, m/s, m/s, rad/s]
struct Twist {
  double x = 0, y = 0, z = 0;
  double a = 0;
  friend constexpr bool operator==(const Twist&, const Twist&) = default;
};

struct Size {
  double x = 0, y = 0, z = 0;  // m
  friend constexpr bool operator==(const Size&, const Size&) = default;
};

/// A heading as cosine and sine; rotates many points for one sincos.
struct Rotation {
  double c = 1, s = 0;

  static Rotation of(double angle) {
    const SinCos sc = sincos(angle);
    return {sc.cos, sc.sin};
  }
  constexpr Vec2 operator*(Vec2 p) const { return {c * p.x - s * p.y, s * p.x + c * p.y}; }
  constexpr Vec2 inverse(Vec2 p) const { return {c * p.x + s * p.y, -s * p.x + c * p.y}; }
};

inline Pose compose(const Pose& X_AB, const Pose& X_BC) {
  const Vec2 p = Rotation::of(X_AB.a) * X_BC.xy();
  return {X_AB.x + p.x, X_AB.y + p.y, X_AB.z + X_BC.z, normalize(X_AB.a + X_BC.a)};
}

inline Pose inverse(const Pose& X_AB) {
  const Vec2 p = Rotation::of(X_AB.a).inverse(X_AB.xy());
  return {-p.x, -p.y, -X_AB.z, normalize(-X_AB.a)};
}

/// p_AP from p_BP.
inline Vec2 transform(const Pose& X_AB, Vec2 p_BP) {
  return X_AB.xy() + Rotation::of(X_AB.a) * p_BP;
}

/// Axis-aligned box. Empty when x_min > x_max.
struct Box {
  double x_min = 1e300, y_min = 1e300, x_max = -1e300, y_max = -1e300;

  constexpr void add(Vec2 p) {
    if (p.x < x_min) x_min = p.x;
    if (p.y < y_min) y_min = p.y;
    if (p.x > x_max) x_max = p.x;
    if (p.y > y_max) y_max = p.y;
  }
  /// Closed: includes its edges.
  constexpr bool contains(Vec2 p) const {
    return p.x >= x_min && p.x <= x_max && p.y >= y_min && p.y <= y_max;
  }
  constexpr bool overlaps(const Box& o) const {
    return x_min <= o.x_max && o.x_min <= x_max && y_min <= o.y_max && o.y_min <= y_max;
  }
  constexpr bool empty() const { return x_min > x_max; }
  constexpr Box grown(double by) const { return {x_min - by, y_min - by, x_max + by, y_max + by}; }
  /// Slab test of the line p + t d: the interval of t inside the box; first > last if it misses.
  constexpr std::pair<double, double> along(Vec2 p, Vec2 d) const {
    double first = -1e300, last = 1e300;
    const auto clip = [&](double low, double high, double from, double step) {
      if (step == 0) {
        if (from < low || from > high) last = -1e300;
        return;
      }
      const double a = (low - from) / step, b = (high - from) / step;
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    };
    clip(x_min, x_max, p.x, d.x);
    clip(y_min, y_max, p.y, d.y);
    return {first, last};
  }
};

}  // namespace playhouse::geom
