#include "playhouse/geom/orientation.h"

#include <algorithm>
#include <cmath>

namespace playhouse::geom {
namespace {

/// Rotation about a unit axis.
Quaternion about(const Vec3& axis, double angle) {
  const SinCos half = sincos(angle / 2);
  return {half.cos, axis.x * half.sin, axis.y * half.sin, axis.z * half.sin};
}

double asin(double sine) {
  return atan2(sine, std::sqrt(std::max(0.0, (1 - sine) * (1 + sine))));
}

}  // namespace

bool is_tilt(Tilt tilt) {
  constexpr double kRounding = 1e-9;
  const double angle = std::sqrt(tilt.x * tilt.x + tilt.y * tilt.y);
  return std::isfinite(angle) && angle <= kPi + kRounding;
}

Quaternion operator*(const Quaternion& p, const Quaternion& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

Quaternion orientation(double heading, Tilt tilt) {
  const Quaternion twist = about({0, 0, 1}, heading);
  const double angle = std::sqrt(tilt.x * tilt.x + tilt.y * tilt.y);
  if (angle == 0) return twist;
  return twist * about({tilt.x / angle, tilt.y / angle, 0}, angle);
}

SpatialPose spatial_pose(const Vec3& p, const Quaternion& q) {
  const double n = std::sqrt(q.w * q.w + q.z * q.z);  // cosine of half the tilt
  const double c = n > 0 ? q.w / n : 1, s = n > 0 ? q.z / n : 0;
  const double x = c * q.x + s * q.y, y = c * q.y - s * q.x;  // of the swing, with the twist removed
  const double sine = std::sqrt(x * x + y * y);
  const double scale = sine > 0 ? 2 * atan2(sine, n) / sine : 0;
  return {{p.x, p.y, p.z, normalize(2 * atan2(s, c))}, {scale * x, scale * y}};
}

SpatialPose compose(const SpatialPose& X_AB, const SpatialPose& X_BC) {
  if (X_AB.tilt == Tilt{}) return {compose(X_AB.X, X_BC.X), X_BC.tilt};
  const Quaternion q_AB = orientation(X_AB.X.a, X_AB.tilt);
  const Vec3 p = q_AB * Vec3{X_BC.X.x, X_BC.X.y, X_BC.X.z};
  return spatial_pose({X_AB.X.x + p.x, X_AB.X.y + p.y, X_AB.X.z + p.z},
                      q_AB * orientation(X_BC.X.a, X_BC.tilt));
}

SpatialPose spatial_pose(const Vec3& p, const RollPitchYaw& turns) {
  if (turns.roll == 0 && turns.pitch == 0) return {{p.x, p.y, p.z, turns.yaw}, {}};
  if (!std::isfinite(turns.roll) || !std::isfinite(turns.pitch) || !std::isfinite(turns.yaw))
    return {{p.x, p.y, p.z, turns.yaw}, {turns.roll, turns.pitch}};
  const Quaternion about_z = about({0, 0, 1}, normalize(turns.yaw)),
                   about_y = about({0, 1, 0}, normalize(turns.pitch)),
                   about_x = about({1, 0, 0}, normalize(turns.roll));
  return spatial_pose(p, about_z * about_y * about_x);
}

RollPitchYaw roll_pitch_yaw(double heading, Tilt tilt) {
  if (tilt == Tilt{}) return {0, 0, heading};
  const Quaternion q = orientation(heading, tilt);
  const double sine = std::min(1.0, std::max(-1.0, 2 * (q.w * q.y - q.z * q.x)));
  return {atan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y)), asin(sine),
          atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))};
}

}  // namespace playhouse::geom
