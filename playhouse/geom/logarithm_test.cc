#include "playhouse/geom/logarithm.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace playhouse::geom {
namespace {

TEST(Log10, is_as_exact_as_it_says) {
  for (int power = -300; power <= 300; ++power) {
    double x = std::pow(10.0, power);
    for (int i = 0; i < 40; ++i, x *= 1.0593)
      EXPECT_NEAR(log10(x), std::log10(x), 1e-15 * (1 + std::fabs(std::log10(x)))) << x;
  }
  EXPECT_EQ(log10(1), 0);
  for (const double near : {1 - 1e-12, 1 + 1e-12}) EXPECT_NEAR(log10(near), std::log10(near), 1e-24);
}

TEST(Log10, gives_the_same_bits_everywhere) {
  std::uint64_t all = 0;
  for (double x = 1e-9; x < 1e9; x *= 1.37) all = all * 31 + std::bit_cast<std::uint64_t>(log10(x));
  EXPECT_EQ(all, 12541214332814864195u);
}

}  // namespace
}  // namespace playhouse::geom
