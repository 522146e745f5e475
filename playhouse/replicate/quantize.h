#pragma once

/// Quantisation of values for viewers.

#include <cstdint>
#include <span>

namespace playhouse::replicate {

/// [m] to [mm] and the like: rounds, saturates to 32 bits, NaN gives 0.
std::int32_t quantize(double value, double per_unit);
/// [rad] to 1/65536 turn.
std::uint16_t quantize_angle(double radians);
/// [m] to a fraction of the sensor's range_max, 65535 at or beyond it.
std::uint16_t quantize_range(double range, double range_max);
/// The same for a span; `out` has room for as many.
void quantize_ranges(std::span<const float> ranges, double range_max, std::uint16_t* out);

}  // namespace playhouse::replicate
