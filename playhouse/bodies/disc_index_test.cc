#include "playhouse/bodies/disc_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "playhouse/base/rng.h"

namespace playhouse::bodies {
namespace {

/// Things in two layers, many to a cell.
DiscIndex::Disc thing(std::size_t i) {
  Rng rng(i);
  const double z = i % 2 == 0 ? 0 : 2, x = rng.uniform(-9, 9);
  return {{x, rng.uniform(-9, 9)}, rng.uniform(0.1, 0.5), z, z + 1, static_cast<std::uint32_t>(i), {0}};
}

DiscIndex index_of(std::size_t count, unsigned threads) {
  std::vector<std::uint8_t> layer;
  for (std::size_t i = 0; i < count; ++i) layer.push_back(i % 2);
  world::Workers workers(threads);
  DiscIndex index;
  index.populate(count, 0.3, layer);
  for (int time = 0; time < 2; ++time) index.rebuild(count, thing, workers);  // also over what was there
  return index;
}

std::vector<std::uint32_t> rows_near(const DiscIndex& index, geom::Vec2 p, double reach, double z) {
  std::vector<std::uint32_t> rows;
  index.near(p, reach, z, z, [&](const DiscIndex::Disc& disc) { rows.push_back(disc.row); });
  return rows;
}

TEST(DiscIndex, is_the_same_for_any_number_of_workers) {
  constexpr std::size_t kCount = 20011;
  const DiscIndex alone = index_of(kCount, 1);
  for (const unsigned threads : {2u, 3u, 7u}) {
    const DiscIndex index = index_of(kCount, threads);
    EXPECT_EQ(index.radius_max(), alone.radius_max());
    for (std::size_t i = 0; i < kCount; ++i) {
      ASSERT_EQ(index.discs()[i].row, alone.discs()[i].row) << threads << " workers, place " << i;
      ASSERT_EQ(index.places().x[i], alone.discs()[i].center.x);
      ASSERT_EQ(index.places().z_max[i], alone.discs()[i].z_max);
    }
    EXPECT_EQ(rows_near(index, {1, 2}, 3, 0.5), rows_near(alone, {1, 2}, 3, 0.5));
  }
}

TEST(DiscIndex, has_everything_near_a_place_also_after_things_came_and_went) {
  world::Workers workers(2);
  DiscIndex index;
  for (const std::size_t count : {10, 9000, 300}) {
    index.populate(count, 0.3);
    index.rebuild(count, thing, workers);
    const std::vector<std::uint32_t> near = rows_near(index, {-2, 3}, 1, 0.5);
    for (std::uint32_t i = 0; i < count; ++i) {
      const DiscIndex::Disc disc = thing(i);
      const geom::Vec2 away = disc.center - geom::Vec2{-2, 3};
      if (geom::dot(away, away) > (1 + disc.radius) * (1 + disc.radius)) continue;
      EXPECT_EQ(std::count(near.begin(), near.end(), i), 1) << i << " of " << count;
    }
  }
}

/// A crowd of things, one in a hundred of which is up to 300 times as large, at two heights.
class MixedSizes {
 public:
  explicit MixedSizes(std::size_t count) {
    std::vector<std::uint8_t> layer;
    std::vector<double> radius;
    for (std::size_t i = 0; i < count; ++i) {
      DiscIndex::Disc disc = thing(i);
      if (i % 100 == 50) disc.radius *= 1 + static_cast<double>(i % 300);
      layer.push_back(i % 2);
      radius.push_back(disc.radius);
      discs_.push_back(disc);
    }
    index_.populate(count, 0.3, layer, radius);
    world::Workers workers(3);
    index_.rebuild(
        count, [&](std::size_t i) { return discs_[i]; }, workers);
  }
  const DiscIndex& index() const { return index_; }
  const std::vector<DiscIndex::Disc>& discs() const { return discs_; }

 private:
  std::vector<DiscIndex::Disc> discs_;
  DiscIndex index_;
};

TEST(DiscIndex, has_everything_near_a_place_whatever_its_size) {
  const MixedSizes mixed(5000);
  std::vector<DiscIndex::Run> room(mixed.index().most_runs());
  for (std::uint64_t k = 0; k < 200; ++k) {
    Rng rng(k);
    const geom::Vec2 p{rng.uniform(-60, 60), rng.uniform(-60, 60)};
    const std::vector<std::uint32_t> near = rows_near(mixed.index(), p, 1, 0.5);
    std::vector<std::uint32_t> in_runs;
    for (std::size_t size = 0; size < mixed.index().radii().size(); ++size)
      for (const DiscIndex::Run& run : mixed.index().find_runs(size, p, 1, 0.5, 0.5, room))
        for (std::uint32_t i = run.begin; i < run.end; ++i) {
          EXPECT_LE(mixed.index().discs()[i].radius, mixed.index().radii()[size]);
          in_runs.push_back(mixed.index().discs()[i].row);
        }
    EXPECT_EQ(in_runs, near);
    for (const DiscIndex::Disc& disc : mixed.discs()) {
      const geom::Vec2 away = disc.center - p;
      if (disc.z_min > 0.5 || geom::dot(away, away) > (1 + disc.radius) * (1 + disc.radius)) continue;
      EXPECT_EQ(std::count(near.begin(), near.end(), disc.row), 1) << disc.row;
    }
  }
}

TEST(DiscIndex, keeps_the_sizes_of_a_mixed_crowd_apart) {
  const MixedSizes mixed(5000);
  const auto radii = mixed.index().radii();
  EXPECT_GT(radii.size(), 3u);
  EXPECT_TRUE(std::is_sorted(radii.begin(), radii.end()));
  EXPECT_LT(radii.front(), 0.5);
  EXPECT_EQ(radii.back(), mixed.index().radius_max());
  EXPECT_GT(radii.back(), 60);
}

/// How many things a query visits is the figure here, not a time.
TEST(DiscIndex, looks_no_farther_for_small_things_where_there_is_a_large_one) {
  const auto visited = [](double largest) {
    std::vector<double> radius;
    std::vector<DiscIndex::Disc> discs;
    for (std::size_t i = 0; i < 10000; ++i) {
      radius.push_back(i == 7 ? largest : 0.15);
      const auto x = static_cast<double>(i % 100), y = static_cast<double>(i / 100);
      discs.push_back({i == 7 ? geom::Vec2{-30, -30} : geom::Vec2{x, y},
                       radius[i],
                       0,
                       1,
                       static_cast<std::uint32_t>(i),
                       {0}});
    }
    DiscIndex index;
    index.populate(discs.size(), 0.15, {}, radius);
    world::Workers workers(1);
    index.rebuild(
        discs.size(), [&](std::size_t i) { return discs[i]; }, workers);
    std::size_t visits = 0;
    for (const DiscIndex::Disc& disc : discs)
      index.near(disc.center, 0.5, 0, 1, [&](const DiscIndex::Disc& /*other*/) { ++visits; });
    return visits;
  };
  EXPECT_LE(visited(10), visited(0.15) + 20000);  // at most itself, for each, and what is near its place
}

}  // namespace
}  // namespace playhouse::bodies
