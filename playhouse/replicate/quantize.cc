#include "playhouse/replicate/quantize.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "playhouse/geom/pose.h"

namespace playhouse::replicate {
namespace {

constexpr double kWhole = 65535;

/// A range times 65535 / range_max, rounded; the whole of it for what is not a number. No calls and no
/// branches, so that a loop over ranges becomes vector instructions.
inline std::uint16_t part_of(double range, double per_metre) {
  const double scaled = range * per_metre, below = scaled < kWhole ? scaled : kWhole,
               clipped = below > 0 ? below : 0;
  constexpr double kAlmostHalf = 0.49999999999999994;  // 0.5 would round up what is just below a half
  return static_cast<std::uint16_t>(static_cast<std::int32_t>(clipped + kAlmostHalf));
}

}  // namespace

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
  if (!(range_max > 0)) return 0xFFFF;
  return part_of(range, kWhole / range_max);
}

void quantize_ranges(std::span<const float> ranges, double range_max, std::uint16_t* out) {
  if (!(range_max > 0)) {
    std::fill_n(out, ranges.size(), 0xFFFF);
    return;
  }
  const double per_metre = kWhole / range_max;
  const float* __restrict const range = ranges.data();
  std::uint16_t* __restrict const to = out;
  for (std::size_t i = 0; i < ranges.size(); ++i) to[i] = part_of(static_cast<double>(range[i]), per_metre);
}

}  // namespace playhouse::replicate
