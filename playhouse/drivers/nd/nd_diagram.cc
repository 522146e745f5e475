#include "playhouse/drivers/nd/nd_diagram.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace playhouse::drivers {
namespace {

using geom::kPi;
using geom::normalize;
using geom::Vec2;

constexpr double kSame = geom::radians(20);  // between directions of the same region in two steps
constexpr double kWeightLast = 0.8;          // of the direction chosen last, against that of the goal

double length(Vec2 p) {
  return std::sqrt(dot(p, p));
}

Vec2 polar(double bearing, double distance) {
  return distance * (geom::Rotation::of(bearing) * Vec2{1, 0});
}

/// In [0, pi/2]; pi/2 for ratios from 1 on.
double arcsin(double ratio) {
  return ratio >= 1 ? kPi / 2 : geom::atan2(ratio, std::sqrt(1 - ratio * ratio));
}

/// A change of distance between neighbouring sectors, beside which the robot may drive on.
struct Gap {
  std::size_t corner = 0;  // sector of the nearer obstacle
  int side = 0;            // of its free side: 1 left, -1 right
};

std::size_t neighbour(std::size_t sector, int side) {
  const auto count = static_cast<int>(NdDiagram::kSectors);
  return static_cast<std::size_t>((static_cast<int>(sector) + side + count) % count);
}

/// True if the robot fits between the depths of two neighbouring sectors.
bool opens(const NdSector& from, const NdSector& to, double radius) {
  return from.occupied() && (!to.occupied() || to.distance - from.distance > 2 * radius);
}

std::vector<Gap> find_gaps(const NdDiagram& diagram, double radius) {
  std::vector<Gap> gaps;
  for (std::size_t sector = 0; sector < NdDiagram::kSectors; ++sector) {
    for (const int side : {-1, 1})
      if (opens(diagram[sector], diagram[neighbour(sector, side)], radius)) gaps.push_back({sector, side});
  }
  return gaps;
}

/// Angle from a gap to the region's other end: the next obstacle that stands out, or one as near as the
/// corner.
double width(const NdDiagram& diagram, const Gap& gap, double radius) {
  std::size_t sector = neighbour(gap.corner, gap.side);
  for (std::size_t count = 1; count < NdDiagram::kSectors; ++count) {
    const std::size_t next = neighbour(sector, gap.side);
    const bool ends = diagram[next].distance <= diagram[gap.corner].distance;
    if (ends || opens(diagram[next], diagram[sector], radius))
      return static_cast<double>(count) * NdDiagram::kWidth;
    sector = next;
  }
  return geom::kTwoPi;
}

/// Passes the corner at the distance to keep, or through the middle of a narrow region.
NdRegion region_of(const NdDiagram& diagram, const Gap& gap, const NdWay& way) {
  const double free = width(diagram, gap, way.radius);
  const double off = arcsin((way.radius + way.avoid_distance) / diagram[gap.corner].distance);
  const bool wide = free >= 2 * off;
  const double corner = NdDiagram::bearing(gap.corner) + gap.side * NdDiagram::kWidth / 2;
  return {normalize(corner + gap.side * (wide ? off : free / 2)), false, wide};
}

}  // namespace

double clearance(const geom::Box& body, Vec2 p) {
  const double x = std::max({body.x_min - p.x, p.x - body.x_max, 0.0});
  const double y = std::max({body.y_min - p.y, p.y - body.y_max, 0.0});
  return std::sqrt(x * x + y * y);
}

double NdDiagram::bearing(std::size_t sector) {
  return (static_cast<double>(sector) + 0.5) * kWidth - kPi;
}

void NdDiagram::add(Vec2 p_RC) {
  const double distance = length(p_RC), off_body = clearance(body_, p_RC);
  if (!(distance < kNdSight) || off_body <= 0) return;
  const double place = (geom::atan2(p_RC.y, p_RC.x) + kPi) / kWidth;
  NdSector& sector = sectors_[std::min(kSectors - 1, static_cast<std::size_t>(std::max(0.0, place)))];
  if (distance < sector.distance) {
    sector.distance = distance;
    sector.p_RC = p_RC;
  }
  if (off_body < sector.clearance) {
    sector.clearance = off_body;
    sector.nearest = p_RC;
  }
}

bool can_reach(const NdDiagram& diagram, double radius, Vec2 p_RP) {
  const double way = length(p_RP);
  const geom::Rotation ahead = geom::Rotation::of(geom::atan2(p_RP.y, p_RP.x));
  std::vector<Vec2> left, right;  // of the straight way, along x
  for (const NdSector& sector : diagram.sectors()) {
    if (!sector.occupied()) continue;
    const Vec2 p = ahead.inverse(sector.p_RC);
    if (length(p - Vec2{way, 0}) < radius) return false;
    if (p.x > 0 && p.x < way + radius) (p.y > 0 ? left : right).push_back(p);
  }
  const double apart = 4 * radius * radius;
  for (const Vec2 one : left) {
    for (const Vec2 other : right)
      if (dot(one - other, one - other) < apart) return false;
  }
  return true;
}

std::optional<NdRegion> choose_region(const NdDiagram& diagram, const NdWay& way) {
  const double wanted = geom::atan2(way.p_RG.y, way.p_RG.x);
  const Vec2 goal = polar(wanted, std::min(length(way.p_RG), kNdSight));
  if (can_reach(diagram, way.radius, goal)) return NdRegion{wanted, true, true};

  std::optional<NdRegion> best;
  double least = 0;
  for (const Gap& gap : find_gaps(diagram, way.radius)) {
    const NdRegion region = region_of(diagram, gap, way);
    const double cost = std::abs(normalize(region.direction - wanted)) +
                        (way.last ? kWeightLast * std::abs(normalize(region.direction - *way.last)) : 0);
    if (best && cost >= least) continue;
    const bool again = way.last && std::abs(normalize(region.direction - *way.last)) < kSame;
    const double radius = again ? way.radius - way.spare : way.radius;
    if (!can_reach(diagram, radius, polar(region.direction, diagram[gap.corner].distance))) continue;
    best = region;
    least = cost;
  }
  return best;
}

}  // namespace playhouse::drivers
