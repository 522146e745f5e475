#include "playhouse/drivers/nd/nd_guard.h"

#include <algorithm>
#include <vector>

namespace playhouse::drivers {
namespace {

using geom::Vec2;

constexpr double kMargin = 0.03;       // m; not to come nearer to obstacles
constexpr double kDriveTime = 0.4;     // s; of a drive, besides the time in which it could stop
constexpr double kDeceleration = 0.5;  // m/s^2; assumed
constexpr double kLongest = 5;         // s; of a drive, at any speed
constexpr double kTurnTime = 0.6;      // s; of a turn on the spot
constexpr double kStep = 0.1;          // s
constexpr int kSpeeds = 8;             // fractions of the wanted speed that are tried

struct Near {
  Vec2 p_RC;
  double clearance = 0;  // m; now
};

std::vector<Near> near_points(const NdDiagram& diagram, double reach) {
  std::vector<Near> points;
  for (const NdSector& sector : diagram.sectors())
    if (sector.occupied() && sector.clearance < reach) points.push_back({sector.nearest, sector.clearance});
  return points;
}

/// True if the body touches at this pose what it would be farther from now.
bool touches(const std::vector<Near>& points, const geom::Box& body, const geom::Pose& X_RM) {
  const geom::Rotation R_RM = geom::Rotation::of(X_RM.a);
  for (const Near& point : points) {
    const double then = clearance(body, R_RM.inverse(point.p_RC - X_RM.xy()));
    if (then < kMargin && then < point.clearance) return true;
  }
  return false;
}

/// True if the body touches nothing at this velocity for a time.
bool is_free(const std::vector<Near>& points, const geom::Box& body, const NdVelocity& velocity,
             double time) {
  const geom::Pose X_MN{kStep * velocity.speed, 0, 0, kStep * velocity.turn_rate};
  geom::Pose X_RM;
  for (int step = 1; step * kStep <= time + kStep / 2; ++step) {
    X_RM = geom::compose(X_RM, X_MN);
    if (touches(points, body, X_RM)) return false;
  }
  return true;
}

double drive_time(double speed) {
  return std::min(kLongest, kDriveTime + speed / (2 * kDeceleration));
}

}  // namespace

NdVelocity guarded(const NdDiagram& diagram, const geom::Box& body, const NdVelocity& wanted) {
  const double size = (body.x_max - body.x_min) + (body.y_max - body.y_min);
  const double reach = wanted.speed * drive_time(wanted.speed) + size + kMargin;
  const std::vector<Near> points = near_points(diagram, reach);
  const bool can_turn = is_free(points, body, {0, wanted.turn_rate}, kTurnTime);
  const double turn_rate = can_turn ? wanted.turn_rate : 0;
  for (int part = kSpeeds; part > 0; --part) {
    const double speed = wanted.speed * part / kSpeeds;
    if (is_free(points, body, {speed, turn_rate}, drive_time(speed))) return {speed, turn_rate};
  }
  return {0, turn_rate};
}

}  // namespace playhouse::drivers
