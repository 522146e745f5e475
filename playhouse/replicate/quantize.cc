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

// Call-free and branch-free within the range, so that quantize_ranges() is vectorised.
std::uint16_t quantize_range(double range, double range_max) {
  if (!(range_max > 0)) return 0xFFFF;
  constexpr double kWhole = 0xFFFF;
  const double scaled = range * (kWhole / range_max), below = scaled < kWhole ? scaled : kWhole,
               clipped = below > 0 ? below : 0;
  constexpr double kAlmostHalf = 0.49999999999999994;  // 0.5 would round up the value just below a half
  return static_cast<std::uint16_t>(static_cast<std::int32_t>(clipped + kAlmostHalf));
}

void quantize_ranges(std::span<const float> ranges, double range_max, std::uint16_t* __restrict out) {
  const float* __restrict const range = ranges.data();
  for (std::size_t i = 0; i < ranges.size(); ++i)
    out[i] = quantize_range(static_cast<double>(range[i]), range_max);
}

}  // namespace playhouse::replicate
