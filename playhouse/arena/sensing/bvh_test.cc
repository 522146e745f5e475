#include "playhouse/arena/sensing/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "playhouse/base/rng.h"

namespace playhouse::arena {
namespace {

bool contains(const Bounds& outer, const Bounds& inner) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
  return true;
}

/// Counts how often each box is in a leaf below a node, and checks that boxes contain what is below them.
std::size_t check(const Bvh& bvh, std::span<const Bounds> boxes, std::uint32_t node,
                  std::vector<int>& found) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < Bvh::kWidth; ++i) {
    Bounds box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = bvh.nodes[node].low[axis][i];
      box.high[axis] = bvh.nodes[node].high[axis][i];
    }
    if (box.low[0] > box.high[0]) continue;
    const std::uint32_t child = bvh.nodes[node].child[i];
    if ((child & Bvh::kLeaf) == 0) {
      depth = std::max(depth, check(bvh, boxes, child, found));
      continue;
    }
    const Bvh::Leaf& leaf = bvh.leaves[child & ~Bvh::kLeaf];
    for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
      ++found[bvh.order[k]];
      EXPECT_TRUE(contains(box, boxes[bvh.order[k]]));
    }
  }
  return depth + 1;
}

/// Depth of the hierarchy of boxes, each of which must be in a leaf once.
std::size_t depth_of(std::span<const Bounds> boxes, std::size_t leaf_size) {
  const Bvh bvh = bvh_of(boxes, leaf_size);
  std::vector<int> found(boxes.size());
  const std::size_t depth = check(bvh, boxes, 0, found);
  EXPECT_EQ(std::ranges::count(found, 1), static_cast<std::ptrdiff_t>(boxes.size()));
  for (const Bvh::Leaf& leaf : bvh.leaves) EXPECT_LE(leaf.count, leaf_size);
  return depth;
}

Bounds box_at(float x, float y, float z, float half) {
  return {{x - half, y - half, z - half}, {x + half, y + half, z + half}};
}

TEST(Bvh, has_each_box_in_one_leaf) {
  Rng rng(1);
  std::vector<Bounds> boxes;
  for (const std::size_t count : {1u, 2u, 15u, 16u, 17u, 300u, 5000u}) {
    while (boxes.size() < count) {
      const auto somewhere = [&] { return static_cast<float>(rng.uniform(-50, 50)); };
      boxes.push_back(box_at(somewhere(), somewhere(), somewhere(), static_cast<float>(rng.uniform(0, 1))));
    }
    for (const std::size_t leaf_size : {1u, 16u}) EXPECT_LE(depth_of(boxes, leaf_size), 8u) << count;
  }
}

TEST(Bvh, is_not_too_deep_for_any_boxes) {
  std::vector<Bounds> same(3000, box_at(1, 2, 3, 0.5f)), growing;
  for (int i = 0; i < 3000; ++i) {
    const float x = std::pow(1.02f, static_cast<float>(i));
    growing.push_back(box_at(x, 0, 0, 0.5f * x));
  }
  for (const std::size_t leaf_size : {1u, 16u}) {
    EXPECT_LE(depth_of(same, leaf_size), Bvh::kDepthMax);
    EXPECT_LE(depth_of(growing, leaf_size), Bvh::kDepthMax);
  }
}

TEST(Bvh, takes_coordinates_too_large_for_a_float) {
  std::vector<Bounds> boxes;
  for (int i = 0; i < 100; ++i)
    boxes.push_back(box_at(i % 3 == 0 ? 3e38f : static_cast<float>(i), 0, 0, 3e38f));
  boxes.push_back(box_at(Bounds::kInfinity, 0, 0, 1));
  for (const std::size_t leaf_size : {1u, 16u})
    EXPECT_LE(bvh_of(boxes, leaf_size).leaves.size(), boxes.size());
}

TEST(Bvh, of_nothing_has_no_nodes) {
  EXPECT_TRUE(bvh_of({}, 16).nodes.empty());
}

}  // namespace
}  // namespace playhouse::arena
