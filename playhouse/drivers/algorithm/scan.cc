#include "playhouse/drivers/algorithm/scan.h"

#include <algorithm>
#include <cmath>

namespace playhouse::drivers {
namespace {

constexpr double kMostSpan = 7;                       // rad; of an eye's beams
constexpr double kMostHalfWidth = geom::radians(15);  // of the cone of a lone beam
constexpr double kSameDirection = 1e-3;               // rad

}  // namespace

bool is_usable(const RangeScan& scan) {
  constexpr double kMostAngle = 1e9;  // rad; so that sums of some are finite, too
  const std::size_t beams = scan.beams();
  if (beams == 0 || beams * scan.eyes.size() != scan.ranges.size()) return false;
  if (!(std::fabs(scan.first_angle) <= kMostAngle)) return false;
  return beams == 1 || (scan.angle_step > 0 && scan.angle_step * static_cast<double>(beams - 1) <= kMostSpan);
}

geom::Vec2 end_of_beam(const RangeScan& scan, std::size_t i) {
  const std::size_t beams = scan.beams();
  const double range = scan.ranges[i];
  const geom::Vec2 p_SE = range * (geom::Rotation::of(scan.angle(i % beams)) * geom::Vec2{1, 0});
  return geom::transform(scan.eyes[i / beams].X_RS, p_SE);
}

std::vector<ScanEye> ring_of(const std::vector<geom::Pose>& X_RS) {
  std::vector<ScanEye> eyes;
  eyes.reserve(X_RS.size());
  for (const geom::Pose& eye : X_RS) {
    double half_width = kMostHalfWidth;
    for (const geom::Pose& other : X_RS) {
      const double apart = std::fabs(geom::normalize(other.a - eye.a));
      if (apart > kSameDirection) half_width = std::min(half_width, apart / 2);
    }
    eyes.push_back({eye, half_width});
  }
  return eyes;
}

}  // namespace playhouse::drivers
