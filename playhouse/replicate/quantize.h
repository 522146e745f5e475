#pragma once

/// Whole numbers that travel to viewers, and what they stand for.

#include <cstdint>
#include <span>

namespace playhouse::replicate {

/// [m] to [mm] and the like: rounds, clips to 32 bits, 0 for what is not a number.
std::int32_t quantize(double value, double per_unit);
/// [rad] to 1/65536 turn.
std::uint16_t quantize_angle(double radians);
/// [m] to a fraction of the sensor's range_max, 65535 at or beyond it.
std::uint16_t quantize_range(double range, double range_max);
/// The same of many ranges; `out` has room for them.
void quantize_ranges(std::span<const float> ranges, double range_max, std::uint16_t* out);

}  // namespace playhouse::replicate
