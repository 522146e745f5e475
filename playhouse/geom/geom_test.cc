#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "playhouse/geom/orientation.h"
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

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}

/// About axis x, y or z.
Matrix about(int axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix m{};
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  m[axis][axis] = 1;
  m[i][i] = m[j][j] = c;
  m[i][j] = -s;
  m[j][i] = s;
  return m;
}

Vec3 turned(const Matrix& m, const Vec3& v) {
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

/// The matrix of a heading and a tilt: Rodrigues' formula for the tilt's axis, by turns about z.
Matrix matrix_of(const SpatialPose& X) {
  const double angle = std::hypot(X.tilt.x, X.tilt.y), axis = std::atan2(X.tilt.y, X.tilt.x);
  return product(product(about(2, X.X.a + axis), about(0, angle)), about(2, -axis));
}

double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

rc::Gen<double> within(double most) {
  return rc::gen::map(rc::gen::inRange(-100000, 100001), [most](int n) { return most * n / 100000; });
}

SpatialPose any_pose() {
  const double axis = *within(kPi), angle = *within(kPi);
  return {{*within(10), *within(10), *within(10), *within(kPi)},
          {angle * std::cos(axis), angle * std::sin(axis)}};
}

// Oracle: products of rotation matrices by <cmath>.
RC_GTEST_PROP(SpatialPose, composes_as_matrices_do, ()) {
  const SpatialPose X_AB = any_pose(), X_BC = any_pose(), X_AC = compose(X_AB, X_BC);
  RC_ASSERT(is_tilt(X_AC.tilt));
  const Matrix R_AB = matrix_of(X_AB), R_AC = product(R_AB, matrix_of(X_BC)), found = matrix_of(X_AC);
  for (const Vec3& v : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    RC_ASSERT(distance(turned(R_AC, v), turned(found, v)) < 1e-7);
  const Vec3 p = turned(R_AB, {X_BC.X.x, X_BC.X.y, X_BC.X.z});
  RC_ASSERT(distance({X_AB.X.x + p.x, X_AB.X.y + p.y, X_AB.X.z + p.z}, {X_AC.X.x, X_AC.X.y, X_AC.X.z}) <
            1e-12);
}

RC_GTEST_PROP(SpatialPose, turns_about_fixed_axes_come_back, ()) {
  const double roll = *within(kPi), pitch = *within(1.57), yaw = *within(kPi);
  const SpatialPose X = spatial_pose({}, RollPitchYaw{roll, pitch, yaw});
  const Matrix expected = product(product(about(2, yaw), about(1, pitch)), about(0, roll));
  const Matrix found = matrix_of(X);
  for (const Vec3& v : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    RC_ASSERT(distance(turned(expected, v), turned(found, v)) < 1e-7);
  const RollPitchYaw back = roll_pitch_yaw(X.X.a, X.tilt);
  const Matrix again = product(product(about(2, back.yaw), about(1, back.pitch)), about(0, back.roll));
  for (const Vec3& v : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    RC_ASSERT(distance(turned(expected, v), turned(again, v)) < 1e-7);
}

RC_GTEST_PROP(SpatialPose, of_upright_bodies_is_their_pose_to_the_bit, ()) {
  const SpatialPose X_AB{any_pose().X, {}}, X_BC{any_pose().X, {}};
  RC_ASSERT(compose(X_AB, X_BC) == (SpatialPose{compose(X_AB.X, X_BC.X), {}}));
  const RollPitchYaw turns = roll_pitch_yaw(X_AB.X.a, {});
  RC_ASSERT(turns.roll == 0 && turns.pitch == 0 && turns.yaw == X_AB.X.a);
}

TEST(SpatialPose, rolls_over_its_head_without_turning_round) {
  SpatialPose X;
  for (int step = 1; step <= 40; ++step) {
    X = spatial_pose({}, orientation(0, {0, 0.25}) * orientation(X.X.a, X.tilt));
    ASSERT_NEAR(normalize(X.tilt.y - 0.25 * step), 0, 1e-12) << step;
    ASSERT_NEAR(X.X.a, 0, 1e-12) << step;
    ASSERT_NEAR(X.tilt.x, 0, 1e-12) << step;
  }
}

TEST(SpatialPose, of_turns_that_are_no_numbers_is_none) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  for (const double odd : {nan, infinite, -infinite}) {
    EXPECT_FALSE(is_tilt(spatial_pose({}, RollPitchYaw{odd, 0.1, 0}).tilt));
    EXPECT_FALSE(is_tilt(spatial_pose({}, RollPitchYaw{0.1, odd, 0}).tilt));
    EXPECT_FALSE(std::isfinite(spatial_pose({}, RollPitchYaw{0.1, 0, odd}).X.a));
  }
  for (const double large : {1e6, 1e300, -1.7e308})
    EXPECT_TRUE(is_tilt(spatial_pose({}, RollPitchYaw{large, large, large}).tilt)) << large;
}

TEST(SpatialPose, upside_down_is_a_tilt_and_what_goes_further_is_none) {
  EXPECT_TRUE(is_tilt({0, -kPi}));
  EXPECT_FALSE(is_tilt({3, 3}));
  EXPECT_FALSE(is_tilt({std::nan(""), 0}));
  EXPECT_FALSE(is_tilt({0, std::numeric_limits<double>::infinity()}));
  const SpatialPose X = spatial_pose({}, RollPitchYaw{kPi, 0, 0});
  EXPECT_NEAR(std::hypot(X.tilt.x, X.tilt.y), kPi, 1e-12);
}

// Found by stage_saved_run_fuzz, in a run whose camera looks 3e302 radians to the left.
TEST(SinCos, takes_any_number) {
  for (const double angle : {3.04785e+302, -1e19, 1e18, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()})
    static_cast<void>(sincos(angle));  // under the sanitizers: no undefined behaviour
  EXPECT_NEAR(sincos(1e5).sin, std::sin(1e5), 1e-10);
}

}  // namespace
}  // namespace playhouse::geom
