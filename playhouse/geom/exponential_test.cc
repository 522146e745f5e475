#include "playhouse/geom/exponential.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/rng.h"

namespace playhouse::geom {
namespace {

TEST(Exponential, agrees_with_the_library) {
  Rng random(3);
  for (int i = 0; i < 200000; ++i) {
    const double x = random.uniform(-700, 700), expected = std::exp(x);
    EXPECT_NEAR(exp(x) / expected, 1, 1e-15) << x;
  }
  for (const double x : {0.0, -0.0, 1.0, -1.0, 1e-300, -1e-17, 0.34657359, -0.34657360, 700.0, -700.0})
    EXPECT_NEAR(exp(x) / std::exp(x), 1, 1e-15) << x;
  EXPECT_EQ(exp(0), 1);
}

TEST(Exponential, is_0_far_below) {
  EXPECT_EQ(exp(-701), 0);
  EXPECT_EQ(exp(-HUGE_VAL), 0);
}

}  // namespace
}  // namespace playhouse::geom
