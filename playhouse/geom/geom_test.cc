#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "playhouse/geom/pose.h"
#include "playhouse/geom/trig.h"

namespace playhouse::geom {
namespace {

// Oracle: <cmath>, whose own error is below one unit in the last place.
TEST(Trig, agrees_with_the_library_to_1e_15) {
  for (int i = -200000; i <= 200000; ++i) {
    const double angle = i * 0.37;
    const SinCos sc = sincos(angle);
    ASSERT_NEAR(sc.sin, std::sin(angle), 2e-15) << angle;
    ASSERT_NEAR(sc.cos, std::cos(angle), 2e-15) << angle;
  }
  for (int i = 0; i <= 100000; ++i) {
    const double angle = -kPi + i * (kTwoPi / 100000);
    const double x = 3 * std::cos(angle), y = 3 * std::sin(angle);
    ASSERT_NEAR(atan2(y, x), std::atan2(y, x), 1e-15) << angle;
  }
  EXPECT_EQ(atan2(0, 0), 0);
  EXPECT_EQ(atan2(0, -1), kPi);
}

RC_GTEST_PROP(Trig, normalize_keeps_the_direction, ()) {
  const double angle = *rc::gen::map(rc::gen::inRange(-1000000, 1000000), [](int n) { return n * 0.01; });
  const double turned = normalize(angle);
  RC_ASSERT(turned > -kPi - 1e-9 && turned <= kPi + 1e-9);
  RC_ASSERT(std::fabs(std::sin(turned) - std::sin(angle)) < 1e-9);
  RC_ASSERT(std::fabs(std::cos(turned) - std::cos(angle)) < 1e-9);
}

TEST(Trig, normalize_ends_in_range_for_every_number) {
  for (const double angle : {1e6, 4e9, 1e18, 1e300, 1.7e308}) {
    for (const double turned : {normalize(angle), normalize(-angle)}) {
      EXPECT_GT(turned, -kPi) << angle;
      EXPECT_LE(turned, kPi) << angle;
    }
  }
  EXPECT_NEAR(normalize(1e6) - normalize(999999.5), 0.5, 1e-9) << "across the seam";
  EXPECT_TRUE(std::isnan(normalize(std::nan(""))));
}

TEST(Pose, compose_with_the_inverse_is_the_identity) {
  const Pose X_AB{1.5, -2.0, 0.3, 2.4};
  const Pose X_AA = compose(X_AB, inverse(X_AB));
  EXPECT_NEAR(X_AA.x, 0, 1e-12);
  EXPECT_NEAR(X_AA.y, 0, 1e-12);
  EXPECT_NEAR(X_AA.z, 0, 1e-12);
  EXPECT_NEAR(X_AA.a, 0, 1e-12);
}

TEST(Pose, a_point_ahead_of_a_robot_facing_left_is_to_the_left) {
  const Vec2 p = transform({1, 1, 0, kPi / 2}, {2, 0});
  EXPECT_NEAR(p.x, 1, 1e-12);
  EXPECT_NEAR(p.y, 3, 1e-12);
}

}  // namespace
}  // namespace playhouse::geom
