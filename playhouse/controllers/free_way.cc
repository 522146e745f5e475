#include "playhouse/controllers/free_way.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "playhouse/geom/pose.h"

namespace playhouse::controllers {
namespace {

constexpr int kSide = 18;                    // bearings on either side of straight ahead
constexpr double kApart = geom::radians(5);  // rad
constexpr double kFreeLeast = 0.8;           // m
constexpr double kStraight = 0.3;  // what a bearing off straight ahead counts beside one off the wanted
constexpr double kFar = 1e9;       // m

using Lengths = std::array<double, 2 * kSide + 1>;

double bearing_of(std::size_t k) {
  return (static_cast<double>(k) - kSide) * kApart;
}

std::array<geom::Rotation, 2 * kSide + 1> directions() {
  std::array<geom::Rotation, 2 * kSide + 1> all;
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = geom::Rotation::of(bearing_of(k));
  return all;
}

/// Free length of a strip in each bearing. [m]
Lengths free_lengths(std::span<const float> ranges, const Fan& fan, double half_width) {
  static const auto kDirections = directions();
  Lengths lengths;
  lengths.fill(kFar);
  for (std::size_t beam = 0; beam < ranges.size(); ++beam) {
    const double bearing = fan.first + static_cast<double>(beam) * fan.step;
    const geom::Vec2 p = geom::Rotation::of(bearing) * geom::Vec2{ranges[beam], 0};
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const geom::Vec2 in_strip = kDirections[k].inverse(p);
      if (in_strip.x > 0 && std::fabs(in_strip.y) < half_width) lengths[k] = std::min(lengths[k], in_strip.x);
    }
  }
  return lengths;
}

}  // namespace

std::optional<FreeWay> free_way(std::span<const float> ranges, const Fan& fan, double half_width,
                                double wanted) {
  const Lengths lengths = free_lengths(ranges, fan, half_width);
  std::optional<FreeWay> best;
  double least = kFar;
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    if (lengths[k] < kFreeLeast) continue;
    const double bearing = bearing_of(k);
    const double off = std::fabs(geom::normalize(bearing - wanted)) + kStraight * std::fabs(bearing);
    if (off >= least) continue;
    least = off;
    best = {bearing, lengths[kSide]};
  }
  return best;
}

}  // namespace playhouse::controllers
