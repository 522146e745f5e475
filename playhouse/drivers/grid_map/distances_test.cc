#include "playhouse/drivers/grid_map/distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "playhouse/base/rng.h"

namespace playhouse::drivers {
namespace {

/// Slow and obvious.
std::uint32_t nearest(int width, int height, const std::vector<std::uint8_t>& obstacles, int x, int y) {
  std::uint32_t least = kFarAway;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      if (obstacles[static_cast<std::size_t>(v * width + u)] != 0)
        least = std::min(least, static_cast<std::uint32_t>((u - x) * (u - x) + (v - y) * (v - y)));
  return least;
}

TEST(Distances, agree_with_looking_at_every_obstacle) {
  Rng random(5);
  for (int scene = 0; scene < 60; ++scene) {
    const int width = 1 + static_cast<int>(random.uniform(0, 40)),
              height = 1 + static_cast<int>(random.uniform(0, 40));
    const double share = scene % 4 == 0 ? 0.005 : random.uniform(0, 0.3);
    std::vector<std::uint8_t> obstacles;
    for (int i = 0; i < width * height; ++i) obstacles.push_back(random.uniform() < share ? 1 : 0);
    const std::vector<std::uint32_t> distances = squared_distances(width, height, obstacles);
    ASSERT_EQ(distances.size(), obstacles.size());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        ASSERT_EQ(distances[static_cast<std::size_t>(y * width + x)], nearest(width, height, obstacles, x, y))
            << scene << ": " << width << " x " << height << " at " << x << ", " << y;
  }
}

TEST(Distances, are_cut_far_away) {
  std::vector<std::uint8_t> obstacles(200000);
  EXPECT_EQ(squared_distances(200000, 1, obstacles).back(), kFarAway);
  obstacles[0] = 1;
  for (const bool high : {false, true}) {
    const auto distances =
        high ? squared_distances(1, 200000, obstacles) : squared_distances(200000, 1, obstacles);
    EXPECT_EQ(distances[60000], 60000u * 60000u);
    EXPECT_EQ(distances[199999], kFarAway);
  }
}

}  // namespace
}  // namespace playhouse::drivers
