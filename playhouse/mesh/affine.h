#pragma once

/// Affine: transforms of scene graph nodes, with scale and reflection.

#include <algorithm>
#include <array>
#include <cmath>

#include "playhouse/geom/orientation.h"

namespace playhouse::mesh {

/// p_A = axes p_B + p.
struct Affine {
  std::array<geom::Vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // of B, in A
  geom::Vec3 p;                                                       // of B's origin, in A

  geom::Vec3 turn(const geom::Vec3& v) const { return v.x * axes[0] + v.y * axes[1] + v.z * axes[2]; }
  geom::Vec3 operator*(const geom::Vec3& v) const { return turn(v) + p; }
  /// Determinant: factor of volumes, negative for reflections.
  double volume() const { return dot(axes[0], cross(axes[1], axes[2])); }
};

inline Affine operator*(const Affine& X_AB, const Affine& X_BC) {
  return {{X_AB.turn(X_BC.axes[0]), X_AB.turn(X_BC.axes[1]), X_AB.turn(X_BC.axes[2])}, X_AB * X_BC.p};
}

inline double length(const geom::Vec3& v) {
  return std::sqrt(dot(v, v));
}
/// Normalised; `otherwise` if the length is zero or not finite.
inline geom::Vec3 unit(const geom::Vec3& v, const geom::Vec3& otherwise) {
  const double n = length(v);
  return n > 0 && std::isfinite(n) ? (1 / n) * v : otherwise;
}

/// Transform of normals: the inverse transpose, up to a factor.
inline Affine for_normals(const Affine& X) {
  const double sign = X.volume() < 0 ? -1 : 1;
  return {{sign * cross(X.axes[1], X.axes[2]), sign * cross(X.axes[2], X.axes[0]),
           sign * cross(X.axes[0], X.axes[1])},
          {}};
}

/// The rotation nearest to three axes, orthonormalised in their order, right-handed.
/// Source: Gram-Schmidt; Shepperd, "Quaternion from rotation matrix", 1978.
inline geom::Quaternion rotation_of(const Affine& X) {
  const geom::Vec3 x = unit(X.axes[0], {1, 0, 0});
  const geom::Vec3 across = X.axes[1] - dot(x, X.axes[1]) * x;
  const geom::Vec3 y = unit(across, unit(cross({0, 0, 1}, x), {0, 1, 0})), z = cross(x, y);
  const double trace = x.x + y.y + z.z;
  geom::Quaternion q;
  if (trace > 0) {
    const double s = 2 * std::sqrt(trace + 1);
    q = {s / 4, (y.z - z.y) / s, (z.x - x.z) / s, (x.y - y.x) / s};
  } else if (x.x > y.y && x.x > z.z) {
    const double s = 2 * std::sqrt(std::max(0.0, 1 + x.x - y.y - z.z));
    q = {(y.z - z.y) / s, s / 4, (y.x + x.y) / s, (z.x + x.z) / s};
  } else if (y.y > z.z) {
    const double s = 2 * std::sqrt(std::max(0.0, 1 + y.y - x.x - z.z));
    q = {(z.x - x.z) / s, (y.x + x.y) / s, s / 4, (z.y + y.z) / s};
  } else {
    const double s = 2 * std::sqrt(std::max(0.0, 1 + z.z - x.x - y.y));
    q = {(x.y - y.x) / s, (z.x + x.z) / s, (z.y + y.z) / s, s / 4};
  }
  return q;
}

/// From y-up to z-up: x stays, z becomes -y.
inline Affine from_y_up() {
  return {{{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}, {}};
}

}  // namespace playhouse::mesh
