#include "playhouse/rays/bundle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/simd/testing_instruction_sets.h"
#include "playhouse/stage/engine.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::rays {
namespace {

/// Things of one metre at most within 6 m of p, at two heights, of which rangers do not see all.
bodies::DiscIndex draw_index(Rng& rng, geom::Vec2 p, std::size_t count) {
  std::vector<bodies::DiscIndex::Disc> discs;
  for (std::uint32_t row = 0; row < count; ++row) {
    const double z = rng.uniform() < 0.8 ? 0 : 1;
    bodies::DiscIndex::Disc disc{p + geom::Vec2{rng.uniform(-6, 6), rng.uniform(-6, 6)},
                                 rng.uniform(0.1, 0.5),
                                 z,
                                 z + 0.5,
                                 row,
                                 {row}};
    disc.convex = 4;
    disc.seen_by = rng.uniform() < 0.9 ? bit(bodies::SeenBy::kRanger) : bodies::SeenByBits{0};
    discs.push_back(disc);
  }
  bodies::DiscIndex index;
  world::Workers workers(1);
  index.populate(count, 0.3);
  index.rebuild(
      count, [&](std::size_t i) { return discs[i]; }, workers);
  return index;
}

/// A ranger with a ray every 22.5 degrees, 4 m long, from near its middle.
RangerKind draw_ranger(Rng& rng) {
  scene::SceneDesc scene;
  scene.models.push_back(stage::testing::robot("robot", {}, {0.5, 0.5, 1}));
  scene.models.push_back(stage::testing::ranger("robot.ranger:0", 0, {}));
  for (int k = 0; k < 16; ++k)
    scene.models[1].sensors.push_back(stage::testing::sensor(
        {rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2), 0, k * geom::kPi / 8}, 4, 0, 1));
  const std::unique_ptr<world::Engine> engine = *stage::make_engine(scene, {.seed = 1, .workers = 1});
  RangerKinds kinds;
  kinds.populate(engine->world(), std::vector{0.5});
  return kinds.kinds.at(0);
}

struct Met {
  std::uint32_t row, rays;
  bool operator==(const Met&) const = default;
};

std::vector<Met> find(const Bundle& bundle, const bodies::DiscIndex& index, geom::Vec2 p,
                      geom::Rotation heading, Heights heights) {
  std::vector<bodies::DiscIndex::Run> room(index.most_runs());
  const auto runs = index.find_runs(0, p, bundle.reach, heights.z_low, heights.z_high, room);
  std::vector<std::uint32_t> place(1000), cell(1000);
  std::vector<std::uint16_t> rays(1000);
  const std::size_t count =
      find_bodies(bundle.tables.at(0), index.places(), runs, p, heading, world::ModelRow::kNone, heights,
                  {place.data(), cell.data(), rays.data()});
  std::vector<Met> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back({index.discs()[place[i]].row, rays[i]});
  return all;
}

TEST(FindBodies, finds_all_that_rays_may_meet_wherever_in_the_world) {
  std::size_t pairs = 0, found = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed);
    const geom::Vec2 p = seed % 3 == 0   ? geom::Vec2{0, 0}
                         : seed % 3 == 1 ? geom::Vec2{-7e4, 123456.7}
                                         : geom::Vec2{3e6, -524288};
    const bodies::DiscIndex index = draw_index(rng, p, 300);
    const RangerKind kind = draw_ranger(rng);
    const Bundle& bundle = kind.bundles.at(0);
    const geom::Rotation heading = geom::Rotation::of(rng.uniform(-3, 3));
    const double z = 0.25;
    std::vector<std::vector<Met>> outcomes;
    simd::testing::with_every_instruction_set([&] {
      outcomes.push_back(find(bundle, index, p, heading, {z, z, index.is_all_seen(z, z)}));
    });
    for (const std::vector<Met>& other : outcomes) EXPECT_EQ(other, outcomes.front());
    std::vector<std::uint32_t> rays_of(300);
    for (const Met& met : outcomes.front()) rays_of[met.row] = met.rays;
    for (std::size_t place = 0; place < 300; ++place) {
      const bodies::DiscIndex::Disc& disc = index.discs()[place];
      if (disc.seen_by == 0 || disc.z_min > z) {
        EXPECT_EQ(rays_of[disc.row], 0u);
        continue;
      }
      for (std::size_t k = 0; k < bundle.rays(); ++k) {
        const geom::Vec2 to_disc = disc.center - (p + heading * bundle.p[k]), d = heading * bundle.d[k];
        const double along = std::clamp(geom::dot(d, to_disc), 0.0, bundle.range_max[k]);
        const geom::Vec2 off = to_disc - along * d;
        const bool meets = geom::dot(off, off) <= disc.radius * disc.radius;
        const bool is_found = (rays_of[disc.row] >> k & 1) != 0;
        EXPECT_TRUE(is_found || !meets) << "seed " << seed << ", body " << disc.row << ", ray " << k;
        pairs += meets;
        found += is_found;
      }
    }
  }
  EXPECT_GT(pairs, 3000u);
  EXPECT_LT(found, 4 * pairs) << "the table rules most out";
}

TEST(FindBodies, looks_at_no_heights_where_rangers_see_everything) {
  bodies::DiscIndex index;
  world::Workers workers(1);
  const auto disc = [](double z_max, bodies::SeenByBits seen_by) {
    bodies::DiscIndex::Disc made{{1, 0}, 0.3, 0, z_max, 0, {0}};
    made.seen_by = seen_by;
    return made;
  };
  const auto build = [&](double z_max, bodies::SeenByBits seen_by) {
    index.populate(2, 0.3);
    index.rebuild(
        2,
        [&](std::size_t i) { return i == 0 ? disc(1, bit(bodies::SeenBy::kRanger)) : disc(z_max, seen_by); },
        workers);
  };
  build(0.5, bit(bodies::SeenBy::kRanger));
  EXPECT_TRUE(index.is_all_seen(0.2, 0.5));
  EXPECT_FALSE(index.is_all_seen(0.2, 0.6));
  build(1, bit(bodies::SeenBy::kMotion));
  EXPECT_FALSE(index.is_all_seen(0.2, 0.5));
}

}  // namespace
}  // namespace playhouse::rays
