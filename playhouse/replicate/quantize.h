#pragma once

/// Whole numbers that travel to viewers, and what they stand for.

#include <cstdint>

namespace playhouse::replicate {

/// [m] to [mm] and the like: rounds, clips to 32 bits, 0 for what is not a number.
std::int32_t quantize(double value, double per_unit);
/// [rad] to 1/65536 turn.
std::uint16_t quantize_angle(double radians);
/// [m] to a fraction of the sensor's range_max, 65535 at or beyond it.
std::uint16_t quantize_range(double range, double range_max);

}  // namespace playhouse::replicate
