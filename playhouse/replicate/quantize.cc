#include "playhouse/replicate/quantize.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "playhouse/geom/pose.h"

namespace playhouse::replicate {

std::int32_t quantize(double value, double per_unit) {
  const double scaled = value * per_unit;
  if (!std::isfinite(scaled)) return 0;
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::lround(std::clamp(scaled, -kMost, kMost)));
}

std::uint16_t quantize_angle(double radians) {
  if (!std::isfinite(radians)) return 0;
  const double turns = radians / geom::kTwoPi;
  return static_cast<std::uint16_t>(std::lround((turns - std::floor(turns)) * 65536.0) & 0xFFFF);
}

std::uint16_t quantize_range(double range, double range_max) {
  if (!(range_max > 0) || std::isnan(range)) return 0xFFFF;
  return static_cast<std::uint16_t>(std::lround(std::clamp(range / range_max, 0.0, 1.0) * 65535.0));
}

}  // namespace playhouse::replicate
