#pragma once

/// Poses with six degrees of freedom. A body stands upright at a heading (pose.h), and its tilt comes before
/// that: R_AB = Rz(a) R(tilt). Every rotation is one heading and one tilt: the twist about z and the swing
/// that is left. Bodies that stand upright have tilt zero, and then all of this is pose.h, to the bit.
/// Source: swing-twist decomposition; Dobrowolski, "Swing-twist decomposition in Clifford algebra", 2015.

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

/// A rotation about a horizontal axis: the axis times the angle, which is at most pi. [rad]
struct Tilt {
  double x = 0, y = 0;
  friend constexpr bool operator==(Tilt, Tilt) = default;
};

/// False for what is no tilt: not finite, or further than upside down.
bool is_tilt(Tilt tilt);

/// A rotation; its norm is 1. q and -q are the same one.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
};

Quaternion operator*(const Quaternion& q_AB, const Quaternion& q_BC);
/// v_A from v_B: v + w t + u x t with t = 2 u x v, of q = (w, u).
constexpr Vec3 operator*(const Quaternion& q_AB, const Vec3& v_B) {
  const Vec3 u{q_AB.x, q_AB.y, q_AB.z}, t = 2 * cross(u, v_B);
  return v_B + q_AB.w * t + cross(u, t);
}

/// Where a body is and how it stands. X.a and tilt together are its orientation.
struct SpatialPose {
  Pose X;
  Tilt tilt;
  friend constexpr bool operator==(const SpatialPose&, const SpatialPose&) = default;
};

Quaternion orientation(double heading, Tilt tilt);
/// The pose at p with this orientation; of upside down ones, which have many headings, some one.
SpatialPose spatial_pose(const Vec3& p, const Quaternion& orientation);

/// How a body moves: v is that of its origin, w that about it.
struct SpatialVelocity {
  Vec3 v, w;  // m/s, rad/s
  friend constexpr bool operator==(const SpatialVelocity&, const SpatialVelocity&) = default;
};

SpatialPose compose(const SpatialPose& X_AB, const SpatialPose& X_BC);

/// Turns about the fixed axes x, y and z, in this order: R = Rz(yaw) Ry(pitch) Rx(roll), as Player has them.
/// [rad]
struct RollPitchYaw {
  double roll = 0, pitch = 0, yaw = 0;
};

/// What is not finite stays so.
SpatialPose spatial_pose(const Vec3& p, const RollPitchYaw& turns);
/// Pitch is in [-pi/2, pi/2].
RollPitchYaw roll_pitch_yaw(double heading, Tilt tilt);

}  // namespace playhouse::geom
