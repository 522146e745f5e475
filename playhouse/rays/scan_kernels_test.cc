#include "playhouse/rays/scan_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "playhouse/base/rng.h"
#include "playhouse/simd/testing_instruction_sets.h"

namespace playhouse::rays {
namespace {

constexpr std::size_t kBeams = 61;

/// A convex polygon with corners on an ellipse, as Solids has them.
std::vector<geom::Vec2> draw_polygon(Rng& rng, std::size_t corners) {
  const geom::Vec2 center{rng.uniform(-3, 3), rng.uniform(-3, 3)};
  const double a = rng.uniform(0.1, 0.6), b = rng.uniform(0.1, 0.6), turn = rng.uniform(-3, 3);
  std::vector<geom::Vec2> polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const geom::SinCos at = geom::sincos(turn + (static_cast<double>(i) + rng.uniform(0, 0.5)) *
                                                    geom::kTwoPi / static_cast<double>(corners));
    polygon.push_back(center + geom::Vec2{a * at.cos, b * at.sin});
  }
  polygon.push_back(polygon.front());
  polygon.resize(polygon.size() + bodies::Solids::kPad);
  return polygon;
}

/// What beams about p meet of three polygons, one after the other.
std::vector<double> outcome(std::size_t corners, std::uint64_t seed) {
  Rng rng(seed);
  Scan scan;
  scan.count = kBeams;
  scan.fov = 6;
  scan.step = 0.1;
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x(kBeams + Scan::kPad, none), y(x), range(x.size(), 4.0),
      solid(x.size(), bodies::kNoSolid);
  for (std::size_t k = 0; k < kBeams; ++k) {
    const geom::SinCos ahead = geom::sincos(0.1 * static_cast<double>(k) - 3);
    x[k] = ahead.cos;
    y[k] = ahead.sin;
  }
  geom::Vec2 p{rng.uniform(-1, 1), rng.uniform(-1, 1)};
  for (int body = 0; body < 3; ++body) {
    const std::vector<geom::Vec2> polygon = draw_polygon(rng, corners);
    if (rng.uniform() < 0.1) p = 2 * polygon[0] - polygon[1];  // in line with an edge
    const ScanBeams row(scan, p, x.data(), y.data(), range.data(), solid.data());
    simd::in_vectors<project_facing>(row, polygon.data(), corners, 7.0 - body, 0.0, 9.0, rng.bits() % kBeams,
                                     kBeams - 1);
  }
  range.insert(range.end(), solid.begin(), solid.end());
  return range;
}

TEST(EightLanes, scans_meet_bodies_of_any_number_of_corners_to_the_same_bits) {
  std::size_t met = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const std::size_t corners = 3 + i % (bodies::kConvexCorners - 2);
    std::vector<std::vector<double>> outcomes;
    simd::testing::with_every_instruction_set([&] { outcomes.push_back(outcome(corners, i)); });
    for (const double number : outcomes.front()) met += number == 5 || number == 6 || number == 7;
    for (const std::vector<double>& other : outcomes)
      EXPECT_EQ(other, outcomes.front()) << corners << " corners";
  }
  EXPECT_GT(met, 10000u);
}

/// Places at random, in runs with others between them.
struct Somewhere {
  bodies::DiscIndex::Places places;
  std::vector<bodies::DiscIndex::Run> runs;

  explicit Somewhere(Rng& rng) {
    std::uint32_t count = 0;
    for (int run = 0; run < 9; ++run) {
      const auto length = static_cast<std::uint32_t>(rng.bits() % 20);
      runs.push_back({count, count + length});
      count += length + static_cast<std::uint32_t>(rng.bits() % 5);
    }
    for (std::uint32_t i = 0; i < count + bodies::DiscIndex::kPad; ++i) {
      places.x.push_back(rng.uniform(-4, 4));
      places.y.push_back(rng.uniform(-4, 4));
      places.z_min.push_back(rng.uniform() < 0.8 ? 0 : 1);
      places.z_max.push_back(rng.uniform() < 0.8 ? 1 : 0.1);
    }
  }
};

TEST(EightLanes, scans_find_the_same_bodies_in_the_same_order) {
  std::size_t found = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    Rng rng(i);
    const Somewhere in(rng);
    const geom::SinCos heading = geom::sincos(rng.uniform(-3, 3));
    const Sector sector{{rng.uniform(-1, 1), rng.uniform(-1, 1)}, 2.5, 0.5, {heading.cos, heading.sin}, -0.3};
    std::vector<std::vector<double>> outcomes;
    simd::testing::with_every_instruction_set([&] {
      const std::size_t room = in.places.x.size() + simd::kEight;
      std::vector<double> x(room), y(room);
      std::vector<std::uint32_t> place(room);
      std::vector<double> all;
      const std::size_t near = simd::in_vectors<gather>(sector, 0.2, in.places, in.runs,
                                                        Gathered{x.data(), y.data(), place.data()});
      for (std::size_t k = 0; k < near; ++k)
        all.insert(all.end(), {x[k], y[k], static_cast<double>(place[k])});
      found += near;
      outcomes.push_back(all);
    });
    for (const std::vector<double>& other : outcomes) EXPECT_EQ(other, outcomes.front());
  }
  EXPECT_GT(found, 10000u);
}

}  // namespace
}  // namespace playhouse::rays
