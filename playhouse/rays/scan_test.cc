#include <gtest/gtest.h>

#include "playhouse/rays/bearing.h"

namespace playhouse::rays {
namespace {

TEST(Bearing, is_as_good_as_it_says) {
  for (int i = 0; i <= 100000; ++i) {
    const double angle = -geom::kPi + i * (geom::kTwoPi / 100000);
    const geom::SinCos sc = geom::sincos(angle);
    ASSERT_NEAR(rough_bearing({5 * sc.cos, 5 * sc.sin}), geom::atan2(sc.sin, sc.cos), 0.5 * kBearingError)
        << angle;
  }
}

}  // namespace
}  // namespace playhouse::rays
