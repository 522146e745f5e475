#include "playhouse/geom/exponential.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "playhouse/base/assert.h"

namespace playhouse::geom {

double exp(double x) {
  constexpr double kPerLn2 = 1.44269504088896340736;
  // ln 2 in two parts; the first has few enough bits that its multiples are exact.
  constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;
  PLAYHOUSE_ASSERT(x <= 700);
  if (!(x >= -700)) return 0;
  const double k = std::floor(x * kPerLn2 + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;
  double series = 1;
  for (int n = 14; n >= 1; --n) series = 1 + series * r / n;
  const auto exponent = static_cast<std::uint64_t>(static_cast<std::int64_t>(k) + 1023);
  return series * std::bit_cast<double>(exponent << 52);
}

}  // namespace playhouse::geom
