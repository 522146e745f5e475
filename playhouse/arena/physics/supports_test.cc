#include "playhouse/arena/physics/supports.h"

#include <gtest/gtest.h>

#include "playhouse/base/rng.h"

namespace playhouse::arena {
namespace {

Aabb around(const Vec3& middle, const Vec3& half) {
  return {middle - half, middle + half};
}

TEST(Supports, finds_what_comparing_each_with_each_finds) {
  Rng rng(7);
  const auto any = [&rng](double most) {
    const Vec3 middle{rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(0, 2)};
    const Vec3 half{rng.uniform(0, most), rng.uniform(0, 1), rng.uniform(0, 0.5)};
    return around(middle, half);  // drawn in this order by every compiler
  };
  ByRow<RigidBody, Aabb> boxes;
  for (int i = 0; i < 200; ++i) boxes.push_back(any(i % 20 == 0 ? 6 : 0.9));
  Supports supports;
  supports.set(boxes);
  std::vector<RigidBodyRow> found;
  std::size_t overlaps = 0;
  for (int i = 0; i < 300; ++i) {
    const Aabb box = any(i % 10 == 0 ? 5 : 0.5);
    std::vector<RigidBodyRow> expected;
    for (const RigidBodyRow body : boxes.rows()) {
      const Aabb& b = boxes[body];
      if (b.high.x < box.low.x || box.high.x < b.low.x || b.high.y < box.low.y || box.high.y < b.low.y ||
          b.high.z < box.low.z || box.high.z < b.low.z)
        continue;
      expected.push_back(body);
    }
    supports.find(box, found);
    EXPECT_EQ(found, expected);
    overlaps += expected.size();
  }
  EXPECT_GT(overlaps, 300u);
}

TEST(Supports, is_empty_without_bodies) {
  Supports supports;
  supports.set({});
  std::vector<RigidBodyRow> found{RigidBodyRow{3}};
  supports.find(around({}, {9, 9, 9}), found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace playhouse::arena
