#pragma once

/// Poses with six degrees of freedom. The orientation of an upright body is its heading (pose.h),
/// with a tilt applied first: R_AB = Rz(a) R(tilt). Any rotation splits into heading and tilt
/// (twist about z, swing). With tilt zero all results equal those of pose.h, to the bit. Source:
/// swing-twist decomposition; Dobrowolski, "Swing-twist decomposition in Clifford algebra", 2015.

#include "playhouse/geom/pose.h"

namespace playhouse::geom {

struct Vec3 {
  double x = 0, y = 0, z = 0;  // m
  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A rotation vector with a horizontal axis: axis times angle, at most pi. [rad]
struct Tilt {
  double x = 0, y = 0;
  friend constexpr bool operator==(Tilt, Tilt) = default;
};

/// False for invalid tilts: not finite, or beyond pi.
bool is_tilt(Tilt tilt);

/// A unit quaternion. q and -q are the same rotation.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
};

Quaternion operator*(const Quaternion& q_AB, const Quaternion& q_BC);
/// v_A from v_B: v + w t + u x t with t = 2 u x v, of q = (w, u).
constexpr Vec3 operator*(const Quaternion& q_AB, const Vec3& v_B) {
  const Vec3 u{q_AB.x, q_AB.y, q_AB.z}, t = 2 * cross(u, v_B);
  return v_B + q_AB.w * t + cross(u, t);
}

/// Position and orientation; the latter is X.a with tilt.
struct SpatialPose {
  Pose X;
  Tilt tilt;
  friend constexpr bool operator==(const SpatialPose&, const SpatialPose&) = default;
};

Quaternion orientation(double heading, Tilt tilt);
/// The pose at p with this orientation; the heading of an upside-down body is arbitrary.
SpatialPose spatial_pose(const Vec3& p, const Quaternion& orientation);

/// Rigid-body velocity: v of its origin, w angular.
struct SpatialVelocity {
  Vec3 v, w;  // m/s, rad/s
  friend constexpr bool operator==(const SpatialVelocity&, const SpatialVelocity&) = default;
};

SpatialPose compose(const SpatialPose& X_AB, const SpatialPose& X_BC);

/// Rotations about the fixed axes x, y, z, in this order:
/// R = Rz(yaw) Ry(pitch) Rx(roll), as in Player. [rad]
struct RollPitchYaw {
  double roll = 0, pitch = 0, yaw = 0;
};

/// Non-finite values are passed on.
SpatialPose spatial_pose(const Vec3& p, const RollPitchYaw& turns);
/// Pitch is in [-pi/2, pi/2].
RollPitchYaw roll_pitch_yaw(double heading, Tilt tilt);

}  // namespace playhouse::geom
