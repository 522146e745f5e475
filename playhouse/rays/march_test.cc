#include "playhouse/rays/march.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/bodies/ray_edge.h"
#include "playhouse/simd/testing_instruction_sets.h"

namespace playhouse::rays {
namespace {

/// Square posts that stand still, by their lower left corners.
bodies::Solids posts(const std::vector<geom::Vec2>& corners, double side) {
  bodies::Solids solids;
  solids.first_vertex.push_back(solids.p.next());
  for (const geom::Vec2 p : corners) {
    for (const geom::Vec2 e : {geom::Vec2{0, 0}, geom::Vec2{side, 0}, geom::Vec2{side, side},
                               geom::Vec2{0, side}, geom::Vec2{0, 0}})
      solids.p.push_back(p + e);
    solids.first_vertex.push_back(solids.p.next());
    solids.model.push_back({0});
    solids.z_min.push_back(0);
    solids.z_max.push_back(1);
    solids.seen_by.push_back(bit(bodies::SeenBy::kRanger));
  }
  solids.p.resize(solids.p.size() + bodies::Solids::kPad);
  solids.first_moving = solids.model.next();
  return solids;
}

/// Of posts with sides of `side`.
double nearest(const bodies::Solids& solids, double side, geom::Vec2 p, geom::Vec2 d, double range) {
  for (const bodies::SolidRow row : solids.rows()) {
    const std::span<const geom::Vec2> polygon = solids.polygon(row);
    if (std::fabs(geom::cross(polygon[0] - p, d)) > 2 * side)
      continue;  // off the line by more than its diagonal
    for (std::size_t i = 0; i < polygon.size(); ++i)
      range = std::min(range, bodies::edge_hit(polygon[i] - p, polygon[(i + 1) % polygon.size()] - p, d));
  }
  return range;
}

/// Posts are in a cell's corner and rays clip just that: the rounding of single precision takes some of them
/// through the cells on both sides of the corner, but not through this one.
void expect_every_post_met(std::size_t count) {
  constexpr double kSide = 0.04;
  const double cell = bodies::Walls(posts(std::vector<geom::Vec2>(count), kSide)).torus().cell(),
               range = (kFarthestMarch - 1) * cell;
  Rng rng(1);
  std::vector<geom::Vec2> corners, aims;
  for (std::size_t i = 0; i < count; ++i) {
    const double right = i % 2 ? 1 : -1, up = i % 4 < 2 ? 1 : -1;
    const geom::Vec2 meeting{right * std::floor(rng.uniform(10, 5000)) * cell,  // of four cells
                             up * std::floor(rng.uniform(10, 5000)) * cell};
    const double in = 1e-6 * cell;
    corners.push_back({right > 0 ? meeting.x - in - kSide : meeting.x + in,
                       up > 0 ? meeting.y + in : meeting.y - in - kSide});
    aims.push_back(meeting - geom::Vec2{right * rng.uniform(0, 0.002) * cell, 0});
  }
  const bodies::Solids solids = posts(corners, kSide);
  const bodies::Walls walls(solids);
  ASSERT_NEAR(walls.torus().cell(), cell, 1e-12);

  std::size_t far = 0;
  for (std::size_t first = 0; first < count; first += Rays::kMost) {
    Rays rays;  // as they start
    rays.count = std::min(Rays::kMost, count - first);
    rays.parts[0] = {{0, 0}, 0, rays.count, range, {0}, false, true};
    rays.part_count = 1;
    for (std::size_t k = 0; k < rays.count; ++k) {
      const geom::Vec2 aim = aims[first + k];
      const double length = std::sqrt(geom::dot(aim, aim));
      rays.px[k] = rays.py[k] = 0;
      rays.dx[k] = aim.x / length;
      rays.dy[k] = aim.y / length;
      rays.z[k] = 0.5;
      rays.range[k] = range;
      rays.solid[k] = bodies::kNoSolid;
    }
    std::vector<double> expected;
    for (std::size_t k = 0; k < rays.count; ++k)
      expected.push_back(nearest(solids, kSide, rays.p(k), rays.d(k), range));
    simd::testing::with_every_instruction_set([&] {
      Rays marched = rays;
      march(walls, bit(bodies::SeenBy::kRanger), marched);
      for (std::size_t k = 0; k < marched.count; ++k) {
        EXPECT_EQ(marched.range[k], expected[k]);
        far += marched.solid[k] != bodies::kNoSolid && marched.range[k] > 4000 * cell;
      }
    });
  }
  EXPECT_GT(far, 100u);
}

TEST(March, comes_by_every_edge_however_many_cells_away) {
  expect_every_post_met(4000);
}

TEST(March, comes_by_every_edge_where_there_are_so_many_that_cells_are_larger) {
  EXPECT_GT(bodies::Walls(posts(std::vector<geom::Vec2>(5000), 0.04)).torus().cell(),
            2 * bodies::Walls(posts(std::vector<geom::Vec2>(4000), 0.04)).torus().cell());
  expect_every_post_met(5000);
}

}  // namespace
}  // namespace playhouse::rays
