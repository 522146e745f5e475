#include "playhouse/stage/headroom.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/rng.h"
#include "playhouse/bodies/fast_bodies.h"
#include "playhouse/bodies/overlap.h"
#include "playhouse/bodies/space.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::stage {
namespace {

double length(geom::Vec2 v) {
  return std::sqrt(geom::dot(v, v));
}

/// Trees that go about at random, and may go through each other; every `hasty`-th one now and then by leaps
/// of up to 3 m.
class Wanderers {
 public:
  explicit Wanderers(const scene::SceneDesc& scene, std::uint32_t hasty = 0)
      : scene_(scene), world_(scene_, 1), shapes_(scene_), hasty_(hasty) {
    trees_ = bodies::make_trees(world_);
    solids_ = make_fixed_solids(world_, shapes_);
    replace_moving_solids(solids_, world_, shapes_, trees_);
    walls_ = bodies::Walls(solids_);
    headroom_.populate(trees_, solids_, world_.models);
    index_.populate(solids_.moving(), 0.2);
  }

  /// A tick; adds to `free` and `others` how many trees had headroom and how many had not.
  void go(std::uint64_t tick, std::size_t* free, std::size_t* others) {
    index_.rebuild(
        solids_.moving(), [&](std::size_t i) { return disc_of(solids_, solids_.moving_rows()[i]); },
        workers_);
    ByRow<bodies::Trees, geom::Pose> next;
    ByRow<bodies::Trees, double> reach;
    for (const bodies::TreeRow tree : trees_.rows()) {
      Rng rng(7, tick, {Purpose::kTestScene, tree.index});
      geom::Pose X = world_.models.X_WM[trees_.root[tree]];
      const double x = X.x, y = X.y, turn = rng.uniform(-0.05, 0.05);
      const bool leaps = hasty_ > 0 && tree.index % hasty_ == 0 && rng.uniform() < 0.3;
      const double far = leaps ? 2 : 0.03;
      X.x += rng.uniform(-far, far);
      X.y += rng.uniform(-far, far);
      X.a += turn;
      reach.push_back(length({X.x - x, X.y - y}) + std::fabs(turn) * headroom_.arm(tree));
      next.push_back(X);
    }
    fast_.find(trees_, solids_, reach, workers_);
    leaps_ += !fast_.empty();
    headroom_.begin(fast_.reach_of_others());
    std::vector<bodies::TreeRow> are_free;
    for (const bodies::TreeRow tree : trees_.rows()) {
      const geom::Vec2 p = world_.models.X_WM[trees_.root[tree]].xy();
      const double way = length(next[tree].xy() - p);
      headroom_.avoid(tree, p, fast_);
      bool is_free = headroom_.spend(tree, way);
      if (!is_free) {
        headroom_.measure(tree, p, way, solids_, index_, walls_);
        headroom_.avoid(tree, p, fast_);
        is_free = headroom_.spend(tree, way);
      }
      if (is_free) are_free.push_back(tree);
      ++*(is_free ? free : others);
    }
    const bodies::Solids before = solids_;
    ByRow<bodies::Trees, geom::Vec2> from;
    for (const bodies::TreeRow tree : trees_.rows()) {
      geom::Pose& X_WM = world_.models.X_WM[trees_.root[tree]];
      from.push_back(X_WM.xy());
      X_WM = next[tree];
    }
    for (const bodies::TreeRow tree : trees_.rows()) turn(solids_, world_.models, trees_.models_of(tree));
    place(solids_, world_.models, solids_.moving_rows());
    for (const bodies::TreeRow tree : are_free)
      for (const geom::Vec2 p : {from[tree], next[tree].xy()}) {
        expect_clear_about(p, tree, before);
        expect_clear_about(p, tree, solids_);
      }
  }

  std::size_t leaps() const { return leaps_; }

 private:
  /// The circle about `p` that holds the tree however it turns is clear of all other solids.
  void expect_clear_about(geom::Vec2 p, bodies::TreeRow tree, const bodies::Solids& solids) const {
    double radius = 0;
    for (const bodies::SolidRow row : trees_.solids_of(tree))
      radius = std::max(radius, length(solids.center_M[row]) + solids.radius[row]);
    for (const bodies::SolidRow row : solids.rows()) {
      if (solids.tree[row] == tree) continue;
      if (row >= solids.first_moving) EXPECT_GT(length(solids.center[row] - p), radius + solids.radius[row]);
      const std::span<const geom::Vec2> wall = solids.polygon(row);
      for (std::size_t i = 0; row < solids.first_moving && i < wall.size(); ++i)
        EXPECT_GT(bodies::distance_to_segment(p, wall[i], wall[(i + 1) % wall.size()]), radius);
    }
  }

  scene::SceneDesc scene_;
  world::World world_;
  bodies::Shapes shapes_;
  bodies::Trees trees_;
  bodies::Solids solids_;
  bodies::Walls walls_;
  bodies::DiscIndex index_;
  Headroom headroom_;
  bodies::FastBodies fast_;
  std::uint32_t hasty_;
  std::size_t leaps_ = 0;  // ticks with fast bodies
  world::Workers workers_{1};
};

TEST(Headroom, who_has_some_is_out_of_reach_of_all_others) {
  Wanderers wanderers(testing::crowd(36, testing::Sensing::kNone));
  std::size_t free = 0, others = 0;
  for (std::uint64_t tick = 0; tick < 200; ++tick) wanderers.go(tick, &free, &others);
  EXPECT_GT(free, 4000u);   // most of 7200
  EXPECT_GT(others, 100u);  // and some meet
}

TEST(Headroom, holds_for_all_others_when_some_leap_about) {
  Wanderers wanderers(testing::crowd(36, testing::Sensing::kNone), 12);
  std::size_t free = 0, others = 0;
  for (std::uint64_t tick = 0; tick < 400; ++tick) wanderers.go(tick, &free, &others);
  EXPECT_GT(wanderers.leaps(), 150u);  // of 400 ticks
  EXPECT_GT(free, 4000u);              // of 14400: the leaps are local
  EXPECT_GT(others, 100u);
}

}  // namespace
}  // namespace playhouse::stage
