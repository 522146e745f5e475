#include "playhouse/drivers/amcl/particle_filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "playhouse/base/rng.h"

namespace playhouse::drivers {
namespace {

using geom::Pose;
using geom::Vec2;

constexpr double kScale = 0.1;  // m

/// Rooms of 12 x 8 m without symmetry, turned and away from the origin.
GridMap rooms() {
  constexpr int kWidth = 120, kHeight = 80;
  GridMap map{{static_cast<float>(kScale), kWidth, kHeight, {3, -2, 0.4}}, {}};
  map.cells.assign(kWidth * kHeight, -1);
  const auto fill = [&](int x0, int y0, int x1, int y1) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) map.cells[static_cast<std::size_t>(y * kWidth + x)] = 1;
  };
  fill(0, 0, kWidth, 2);
  fill(0, kHeight - 2, kWidth, kHeight);
  fill(0, 0, 2, kHeight);
  fill(kWidth - 2, 0, kWidth, kHeight);
  fill(50, 0, 52, 50);   // a wall with a door at its end
  fill(52, 30, 90, 32);  // and one with a door in the room behind
  fill(80, 55, 95, 70);
  fill(20, 20, 26, 35);
  fill(15, 60, 22, 64);
  return map;
}

/// By small steps along the ray.
double range_in(const GridMap& map, const Pose& X_WR, double bearing) {
  const Pose X_GR = geom::compose(geom::inverse(map.X_WG()), X_WR);
  const Vec2 along = geom::Rotation::of(X_GR.a + bearing) * Vec2{1, 0};
  for (double range = 0; range < 8; range += 0.01) {
    const Vec2 p = X_GR.xy() + range * along;
    const int x = static_cast<int>(std::floor(p.x / kScale)), y = static_cast<int>(std::floor(p.y / kScale));
    if (x < 0 || y < 0 || x >= map.width() || y >= map.height()) return 8;
    if (map.cells[static_cast<std::size_t>(y * map.width() + x)] > 0) return range;
  }
  return 8;
}

std::vector<Vec2> hits_in(const GridMap& map, const Pose& X_WR) {
  std::vector<Vec2> hits;
  for (int i = 0; i < 30; ++i) {
    const double bearing = geom::radians(-90 + 180.0 * i / 29), range = range_in(map, X_WR, bearing);
    if (range < 8) hits.push_back(range * (geom::Rotation::of(bearing) * Vec2{1, 0}));
  }
  return hits;
}

double distance(const Pose& a, const Pose& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

class FilterTest : public ::testing::Test {
 protected:
  /// The pose in the grid's frame, in W.
  Pose at(double x, double y, double degrees) const {
    return geom::compose(map.X_WG(), {x, y, 0, geom::radians(degrees)});
  }
  FilterOut begin(const Pose& X_WR, const PoseBelief& start) {
    return filter_step(options, field, {7, step++, start, {}, hits_in(map, X_WR)}, memory);
  }
  /// Drives the robot by `motion`; its odometry is wrong by a tenth.
  FilterOut drive(Pose& X_WR, const Pose& motion) {
    X_WR = geom::compose(X_WR, motion);
    const Pose measured{1.1 * motion.x, 0, 0, 0.9 * motion.a};
    return filter_step(options, field, {7, step++, std::nullopt, measured, hits_in(map, X_WR)}, memory);
  }
  /// Along a circle in the first room and out through the door at its end.
  FilterOut tour(Pose& X_WR) {
    FilterOut out;
    for (int i = 0; i < 40; ++i) out = drive(X_WR, {0.15, 0, 0, geom::radians(9)});
    return out;
  }

  const GridMap map = rooms();
  AmclOptions options;
  const LikelihoodField field{map, options.sensor};
  FilterMemory memory;
  std::uint64_t step = 0;
};

TEST_F(FilterTest, follows_a_robot_whose_odometry_is_wrong) {
  Pose X_WR = at(3.5, 4.5, 0);
  begin(X_WR, {X_WR, {0.01, 0.01, 0.01, 0, 0, 0}});
  const FilterOut out = tour(X_WR);
  EXPECT_LT(distance(out.hypotheses.front().belief.mean, X_WR), 0.1);
  EXPECT_LT(std::fabs(geom::normalize(out.hypotheses.front().belief.mean.a - X_WR.a)), geom::radians(3));
  EXPECT_GT(out.hypotheses.front().weight, 0.9);
}

TEST_F(FilterTest, finds_a_robot_anywhere) {
  Pose X_WR = at(3.5, 4.5, 0);
  const FilterOut first = begin(X_WR, {at(6, 4, 0), {16, 16, 40, 0, 0, 0}});
  const FilterOut out = tour(X_WR);
  EXPECT_LT(distance(out.hypotheses.front().belief.mean, X_WR), 0.1);
  EXPECT_LT(2 * out.particles.size(), first.particles.size()) << "fewer are enough for a narrow belief";
}

TEST_F(FilterTest, finds_a_robot_that_was_carried_away) {
  Pose X_WR = at(3.5, 4.5, 0);
  begin(X_WR, {X_WR, {0.01, 0.01, 0.01, 0, 0, 0}});
  tour(X_WR);
  X_WR = at(8, 1, 30);
  FilterOut out = drive(X_WR, {});
  EXPECT_GT(distance(out.hypotheses.front().belief.mean, X_WR), 2);
  for (int i = 0; i < 60; ++i) out = drive(X_WR, {0.1, 0, 0, geom::radians(9)});
  EXPECT_LT(distance(out.hypotheses.front().belief.mean, X_WR), 0.15);
}

TEST_F(FilterTest, of_a_robot_that_sees_nothing_adds_the_errors_of_its_odometry) {
  memory.particles.assign(5000, at(3, 3, 0));
  const FilterOut out =
      filter_step(options, field, {7, 1, std::nullopt, {1, 0, 0, geom::radians(90)}, {}}, memory);
  const std::array<double, 6> cov = hypotheses_of(memory.particles).front().belief.cov;
  double square = 0;
  for (const Pose& particle : out.particles) {
    const Pose X_GR = geom::compose(geom::inverse(map.X_WG()), particle);
    square += (X_GR.x - 4) * (X_GR.x - 4) / static_cast<double>(out.particles.size());
  }
  EXPECT_NEAR(std::sqrt(square), 0.2, 0.03) << "along x, per metre";
  EXPECT_NEAR(std::sqrt(cov[2]), 0.2 + 0.2 * geom::kPi / 2, 0.05) << "of the heading, per metre and radian";
}

TEST_F(FilterTest, gives_the_same_bits_for_the_same_seed) {
  std::vector<FilterOut> outs;
  for (int run = 0; run < 2; ++run) {
    step = 0;
    Pose X_WR = at(3.5, 4.5, 0);
    begin(X_WR, {X_WR, {1, 1, 40, 0, 0, 0}});
    outs.push_back(tour(X_WR));
  }
  EXPECT_EQ(outs[0].particles, outs[1].particles);
}

/// Of a robot that is carried away, most particles are random.
TEST_F(FilterTest, tells_no_hypotheses_of_random_particles_before_a_scan_has_judged_them) {
  Pose X_WR = at(3.5, 4.5, 0);
  begin(X_WR, {X_WR, {0.01, 0.01, 0.01, 0, 0, 0}});
  tour(X_WR);
  const Pose before = X_WR;
  X_WR = at(8, 1, 30);
  std::size_t random = 0;
  for (int i = 0; i < 5; ++i) {
    const FilterOut out = drive(X_WR, {});
    if (random == 0) EXPECT_LT(distance(out.hypotheses.front().belief.mean, before), 0.5);
    random += memory.random;
    double sum = 0;
    for (const Hypothesis& each : out.hypotheses) sum += each.weight;
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_LE(out.hypotheses.size(), kMostHypotheses);
  }
  EXPECT_GT(random, 0u);
}

TEST(Hypotheses, are_clusters_heaviest_first_with_their_spread) {
  std::vector<Pose> particles;
  for (int i = 0; i < 30; ++i) particles.push_back({5, 5, 0, 0});
  for (int i = -35; i < 35; ++i) {
    const double offset = (i + 0.5) / 100;
    particles.push_back({-2 + offset, 1 + 2 * offset, 0, geom::normalize(geom::kPi + offset)});
  }
  const std::vector<Hypothesis> found = hypotheses_of(particles);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_DOUBLE_EQ(found[0].weight, 0.7);
  EXPECT_NEAR(found[0].belief.mean.x, -2, 1e-12);
  EXPECT_NEAR(found[0].belief.mean.y, 1, 1e-12);
  EXPECT_NEAR(std::fabs(found[0].belief.mean.a), geom::kPi, 1e-12) << "on both sides of the cut";
  const double variance = (70 * 70 - 1) / 12.0 / 1e4;
  const std::array<double, 6> expected{variance,     4 * variance, variance,
                                       2 * variance, 2 * variance, variance};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[0].belief.cov[i], expected[i], 1e-12) << i;
  EXPECT_EQ(found[1].belief.mean, (Pose{5, 5, 0, 0}));
}

TEST(PoseBelief, is_possible_if_its_covariance_is_one) {
  EXPECT_TRUE(is_possible({}));
  EXPECT_TRUE(is_possible({{1, 2, 0, 3}, {1, 4, 1, 2, 2, 1}})) << "everything on a line";
  EXPECT_FALSE(is_possible({{}, {1, 1, 1, 1.1, 0, 0}}));
  EXPECT_FALSE(is_possible({{}, {-1, 1, 1, 0, 0, 0}}));
  EXPECT_TRUE(is_possible({{}, {0, 1, 1, 0, 1, 0}}));
  EXPECT_FALSE(is_possible({{}, {0, 1, 1, 5, 0, 0}})) << "what does not vary does not covary";
  EXPECT_FALSE(is_possible({{}, {0, 0, 1, 0, 3, 3}}));
  EXPECT_FALSE(is_possible({{}, {1, 1, 1, 1, 1, -1}}));
  EXPECT_FALSE(is_possible({{}, {1e308, 1e308, 1e308, 0, 0, 0}}));
  EXPECT_FALSE(is_possible({{}, {1, 1, 1, 0, 0, HUGE_VAL}}));
  EXPECT_FALSE(is_possible({{HUGE_VAL, 0, 0, 0}, {}}));
}

TEST(LikelihoodField, is_best_where_a_wall_begins) {
  GridMap map{{0.1f, 20, 1, {}}, std::vector<std::int8_t>(20, -1)};
  for (std::size_t x = 10; x < 20; ++x) map.cells[x] = 1;
  const LikelihoodField field(map, {});
  const auto at = [&](double x) {
    const Vec2 hit[] = {{x, 0}};
    return field.log_likelihood({0, 0.05, 0, 0}, hit);
  };
  EXPECT_GT(at(1.05), at(0.85));
  EXPECT_GT(at(1.05), at(1.45)) << "within rock";
  EXPECT_NEAR(at(0.55), at(0), 1e-2) << "far away only bad readings are possible";
  EXPECT_NEAR(at(5), std::log(0.1), 1e-6) << "beyond the map";
  EXPECT_EQ(field.log_likelihood({}, {}), 0);
}

/// A map of walls alone has its free cells in the unknown.
TEST(LikelihoodField, knows_free_places) {
  GridMap map{{0.5f, 4, 1, {1, 1, geom::kPi / 2}}, {1, 0, -1, 0}};
  const LikelihoodField one(map, {});
  EXPECT_NEAR(one.free_place(0.9).x, 0.75, 1e-12);
  EXPECT_NEAR(one.free_place(0.9).y, 2.25, 1e-12);
  EXPECT_TRUE(one.is_free({0.75, 2.25}));
  EXPECT_FALSE(one.is_free({0.75, 1.75}));
  EXPECT_FALSE(one.is_free({0.75, 3.25}));
  map.cells = {1, 0, 0, 0};
  EXPECT_TRUE(LikelihoodField(map, {}).is_free({0.75, 1.75}));
  map.cells = {1, 1, 1, 1};
  EXPECT_FALSE(LikelihoodField(map, {}).has_free_cells());
}

}  // namespace
}  // namespace playhouse::drivers
