#include "playhouse/stage/disc_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "playhouse/base/rng.h"

namespace playhouse::stage {
namespace {

/// Things in two layers, many to a cell.
DiscIndex::Disc thing(std::size_t i) {
  Rng rng(i);
  const double z = i % 2 == 0 ? 0 : 2, x = rng.uniform(-9, 9);
  return {{x, rng.uniform(-9, 9)}, rng.uniform(0.1, 0.5), z, z + 1, static_cast<std::uint32_t>(i), 0};
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

}  // namespace
}  // namespace playhouse::stage
