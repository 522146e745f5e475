#include "playhouse/arena/own_solids.h"

#include <gtest/gtest.h>

#include <cmath>

namespace playhouse::arena {
namespace {

OwnSolid box(double x_low, double x_high, double z_low = 0, double z_high = 1) {
  return {{{{x_low, -0.5}, {x_high, -0.5}, {x_high, 0.5}, {x_low, 0.5}}}, z_low, z_high};
}

TEST(InsideOf, ends_where_what_is_solid_without_a_gap_ends) {
  const std::vector<OwnSolid> body{box(-0.2, 0.2), box(0.1, 0.6), box(0.6, 0.7), box(1, 2)};
  EXPECT_NEAR(inside_of(body, {0, 0, 0.5}, {1, 0, 0}), 0.7, 1e-12);
  EXPECT_NEAR(inside_of(body, {0, 0, 0.5}, {-1, 0, 0}), 0.2, 1e-12);
  EXPECT_NEAR(inside_of(body, {0, 0, 0.5}, {0, 1, 0}), 0.5, 1e-12);
  EXPECT_EQ(inside_of(body, {0.8, 0, 0.5}, {1, 0, 0}), 0) << "begins outside";
  EXPECT_EQ(inside_of(body, {0, 0, 1.5}, {1, 0, 0}), 0) << "above";
}

TEST(InsideOf, tops_and_bottoms_end_it) {
  const std::vector<OwnSolid> body{box(-1, 1)};
  const double slope = std::sqrt(0.5);
  EXPECT_NEAR(inside_of(body, {0, 0, 0.9}, {slope, 0, slope}), 0.1 / slope, 1e-12);
  EXPECT_NEAR(inside_of(body, {0, 0, 0.1}, {slope, 0, -slope}), 0.1 / slope, 1e-12);
}

TEST(InsideOf, holes_are_free) {
  OwnSolid ring = box(-1, 1);
  ring.outlines.push_back({{-0.5, -0.4}, {0.5, -0.4}, {0.5, 0.4}, {-0.5, 0.4}});
  const std::vector<OwnSolid> body{ring};
  EXPECT_EQ(inside_of(body, {0, 0, 0.5}, {1, 0, 0}), 0);
  EXPECT_NEAR(inside_of(body, {-0.8, 0, 0.5}, {1, 0, 0}), 0.3, 1e-12);
  EXPECT_NEAR(inside_of(body, {0.7, 0.4, 0.5}, {1, 0, 0}), 0.3, 1e-12) << "past corners of the hole";
}

}  // namespace
}  // namespace playhouse::arena
