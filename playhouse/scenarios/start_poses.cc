#include "playhouse/scenarios/start_poses.h"

#include <algorithm>
#include <cmath>

#include "playhouse/base/assert.h"
#include "playhouse/base/rng.h"

namespace playhouse::scenarios {
namespace {

constexpr std::uint64_t kSeed = 2026;

double draw_heading(std::size_t robot) {
  return Rng(kSeed, 0, {Purpose::kStartHeading, static_cast<std::uint32_t>(robot)})
      .uniform(-geom::kPi, geom::kPi);
}

/// Pixels with a distance of more than `reach` pixels (Chebyshev) to solid ones.
std::vector<std::uint8_t> room_around(const scene::Bitmap& rock, int reach) {
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(rock.width) + x;
  };
  // Separable dilation: rows, then columns.
  std::vector<std::uint8_t> in_row(rock.solid.size(), 1), room(rock.solid.size(), 1);
  for (int y = 0; y < rock.height; ++y) {
    for (int x = 0; x < rock.width; ++x) {
      if (!rock.at(x, y)) continue;
      for (int u = std::max(0, x - reach); u <= std::min(rock.width - 1, x + reach); ++u)
        in_row[index(u, y)] = 0;
    }
  }
  for (int y = 0; y < rock.height; ++y) {
    for (int x = 0; x < rock.width; ++x) {
      if (in_row[index(x, y)]) continue;
      for (int v = std::max(0, y - reach); v <= std::min(rock.height - 1, y + reach); ++v)
        room[index(x, v)] = 0;
    }
  }
  return room;
}

/// Fisher-Yates shuffle with a fixed seed.
void shuffle(std::vector<geom::Vec2>& spots) {
  for (std::size_t k = spots.size(); k > 1; --k) {
    Rng random(kSeed, 0, {Purpose::kStartOrder, static_cast<std::uint32_t>(k)});
    std::swap(spots[k - 1], spots[random.bits() % k]);
  }
}

}  // namespace

std::vector<geom::Pose> about(const std::vector<geom::Vec2>& spots, double jitter) {
  std::vector<geom::Pose> poses;
  poses.reserve(spots.size());
  for (std::size_t k = 0; k < spots.size(); ++k) {
    Rng random(kSeed, 0, {Purpose::kStartSpot, static_cast<std::uint32_t>(k)});
    const double x = spots[k].x + random.uniform(-jitter, jitter);
    const double y = spots[k].y + random.uniform(-jitter, jitter);
    poses.push_back({x, y, 0, draw_heading(k)});
  }
  return poses;
}

std::vector<geom::Pose> in_square(std::size_t count, double side, double radius) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const double cell = side / static_cast<double>(columns);
  const double jitter = cell / 2 - radius;
  PLAYHOUSE_ASSERT(jitter >= 0);
  std::vector<geom::Vec2> spots;
  spots.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    spots.push_back({(static_cast<double>(k % columns) + 0.5) * cell - side / 2,
                     (static_cast<double>(k / columns) + 0.5) * cell - side / 2});
  return about(spots, jitter);
}

namespace {

/// Free spots in a cave, in random order.
std::vector<geom::Vec2> spots_in_cave(const scene::Bitmap& rock, double side) {
  const double pixel = side / rock.width;
  const std::vector<std::uint8_t> room = room_around(rock, static_cast<int>(std::ceil(kRobotRadius / pixel)));
  std::vector<geom::Vec2> spots;
  const auto steps = static_cast<std::size_t>(side / (2 * kRobotRadius));
  const double step = side / static_cast<double>(steps);
  for (std::size_t row = 0; row < steps; ++row) {
    for (std::size_t column = 0; column < steps; ++column) {
      const geom::Vec2 at{(static_cast<double>(column) + 0.5) * step,
                          (static_cast<double>(row) + 0.5) * step};
      const auto x = static_cast<std::size_t>(at.x / pixel), y = static_cast<std::size_t>(at.y / pixel);
      if (room[y * static_cast<std::size_t>(rock.width) + x])
        spots.push_back({at.x - side / 2, side / 2 - at.y});
    }
  }
  shuffle(spots);
  return spots;
}

}  // namespace

std::vector<geom::Pose> in_cave(std::size_t count, const scene::Bitmap& rock, double side) {
  std::vector<geom::Vec2> spots = spots_in_cave(rock, side);
  spots.resize(std::min(spots.size(), count));
  return about(spots, 0);
}

std::vector<geom::Pose> in_caves(std::size_t count, const scene::Bitmap& rock, double side, std::size_t each,
                                 const std::vector<geom::Pose>& caves) {
  constexpr std::size_t kShift = 37;  // offset between the spots of one cave and the next
  const std::vector<geom::Vec2> spots = spots_in_cave(rock, side);
  PLAYHOUSE_ASSERT(spots.size() >= each);
  std::vector<geom::Vec2> all;
  all.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t cave = k / each;
    const geom::Vec2 spot = spots[(k % each + kShift * cave) % spots.size()];
    all.push_back({caves.at(cave).x + spot.x, caves.at(cave).y + spot.y});
  }
  return about(all, 0);
}

}  // namespace playhouse::scenarios
