#include "playhouse/geom/logarithm.h"

#include <bit>
#include <cstdint>

namespace playhouse::geom {

double log10(double x) {
  constexpr double kRootHalf = 0.70710678118654752440, kLn2 = 0.69314718055994530942,
                   kPerLn10 = 0.43429448190325182765;
  constexpr std::uint64_t kMantissa = (std::uint64_t{1} << 52) - 1, kBias = 1022;  // mantissas from 1/2 to 1
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto exponent = static_cast<std::int64_t>(bits >> 52 & 0x7ff) - static_cast<std::int64_t>(kBias);
  double m = std::bit_cast<double>((bits & kMantissa) | kBias << 52);
  if (m < kRootHalf) {
    m *= 2;
    --exponent;
  }
  const double s = (m - 1) / (m + 1), z = s * s;  // |s| < 0.1716
  double series = 0;
  for (int k = 21; k >= 1; k -= 2) series = series * z + 1.0 / k;
  return (static_cast<double>(exponent) * kLn2 + 2 * s * series) * kPerLn10;
}

}  // namespace playhouse::geom
