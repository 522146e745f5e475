#include "playhouse/arena/physics/round_solids.h"

#include <algorithm>
#include <cmath>

#include "playhouse/arena/physics/mesh_solids.h"
#include "playhouse/geom/trig.h"

namespace playhouse::arena {
namespace {

constexpr std::size_t kAround = 24;  // corners of a ring
constexpr std::size_t kRings = 5;    // rings of a hemisphere, without the pole; the first is widest
constexpr std::size_t kPoles = 2;    // they come first
constexpr double kNoSize = 1e-9;     // m, of what has no direction

/// Middle of a ring.
Vec3 middle_of(const Hull& hull, std::size_t first) {
  return 0.5 * (hull[first] + hull[first + kAround / 2]);
}

/// Volume, centre and moments about the centre, of uniform density 1.
struct RoundContent {
  double volume = 0;  // m^3
  Vec3 center;        // m
  Vec3 moments;       // m^5, along the axes of B
};

/// A cylinder, if it has_ends between two hemispheres, whose centroids are 3/8 r beyond its ends.
RoundContent content_of_round(const RoundSolid& solid, bool has_ends) {
  const Vec3 axis = solid.high - solid.low;
  const double r = solid.radius, l = std::sqrt(dot(axis, axis));
  const double tube = geom::kPi * r * r * l, ball = has_ends ? 4 * geom::kPi / 3 * r * r * r : 0;
  const double along = r * r * (0.5 * tube + 0.4 * ball);
  const double across = tube * (l * l / 12 + r * r / 4) + ball * (0.4 * r * r + l * l / 4 + 0.375 * l * r);
  const Vec3 u = l > 0 ? (1 / l) * axis : Vec3{0, 0, 1};
  const auto about = [&](double share) { return across + (along - across) * share * share; };
  return {tube + ball, solid.center(), {about(u.x), about(u.y), about(u.z)}};
}

RoundContent content_of_box(const Hull& hull) {
  Vec3 low = hull.front(), high = hull.front();
  for (const Vec3& p : hull) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 size = high - low;
  const double volume = hull_content(hull).volume;
  const auto about = [volume](double a, double b) { return volume * (a * a + b * b) / 12; };
  return {volume, 0.5 * (low + high), {about(size.y, size.z), about(size.x, size.z), about(size.x, size.y)}};
}

}  // namespace

Hull round_hull(double radius, double half) {
  Hull hull{{0, 0, -half - radius}, {0, 0, half + radius}};
  for (const double side : {-1.0, 1.0})
    for (std::size_t ring = 0; ring < kRings; ++ring) {
      const geom::SinCos up = geom::sincos(0.5 * geom::kPi * static_cast<double>(ring) / kRings);
      for (std::size_t k = 0; k < kAround; ++k) {
        const geom::SinCos a =
            geom::sincos(geom::normalize(2 * geom::kPi * static_cast<double>(k) / kAround));
        hull.push_back({radius * up.cos * a.cos, radius * up.cos * a.sin, side * (half + radius * up.sin)});
      }
    }
  hull.round = half > kNoSize ? Round::kCapsule : Round::kSphere;
  return hull;
}

Hull cylinder_hull(double radius, double half) {
  Hull hull;
  for (const double z : {-half, half})
    for (std::size_t k = 0; k < kAround; ++k) {
      const geom::SinCos a = geom::sincos(geom::normalize(2 * geom::kPi * static_cast<double>(k) / kAround));
      hull.push_back({radius * a.cos, radius * a.sin, z});
    }
  if (radius > kNoSize && half > kNoSize) hull.round = Round::kCylinder;
  return hull;
}

RoundSolid round_of(const Hull& hull) {
  if (hull.round == Round::kCylinder) {
    const Vec3 across = hull[0] - hull[kAround / 2];
    return {middle_of(hull, 0), middle_of(hull, kAround), 0.5 * std::sqrt(dot(across, across))};
  }
  const Vec3 across = hull[kPoles] - hull[kPoles + kAround / 2];
  RoundSolid solid{middle_of(hull, kPoles), middle_of(hull, kPoles + kRings * kAround),
                   0.5 * std::sqrt(dot(across, across))};
  if (hull.round == Round::kSphere) solid.low = solid.high = solid.center();
  return solid;
}

bool is_any_round(std::span<const Hull> hulls) {
  return std::ranges::any_of(hulls, [](const Hull& hull) { return hull.round != Round::kNot; });
}

Vec3 moments_of(std::span<const Hull> hulls, const Vec3& center, double mass) {
  double volume = 0;
  Vec3 sum;
  for (const Hull& hull : hulls) {
    const RoundContent part = hull.round == Round::kNot
                                  ? content_of_box(hull)
                                  : content_of_round(round_of(hull), hull.round != Round::kCylinder);
    const Vec3 arm = part.center - center;
    const double x2 = arm.x * arm.x, y2 = arm.y * arm.y, z2 = arm.z * arm.z;
    volume += part.volume;
    sum = sum + part.moments + part.volume * Vec3{y2 + z2, x2 + z2, x2 + y2};
  }
  return (mass / volume) * sum;
}

}  // namespace playhouse::arena
