#include "playhouse/arena/sensing/ray_index.h"

#include <cmath>

namespace playhouse::arena {
namespace {

constexpr float kRounding = 1e-6f;  // of the corners of a turned box, as a share of their coordinates

Bounds box_of(const Triangles& triangles, const std::array<std::uint32_t, 3>& corner) {
  Bounds box;
  for (const std::uint32_t row : corner) {
    const geom::Vec3& p = triangles.p[row];
    Bounds point;
    for (std::size_t k = 0; k < 3; ++k) point.low[k] = point.high[k] = static_cast<float>((&p.x)[k]);
    box.add(point);
  }
  return box;
}

/// Of the box of a shape at a pose, in F; larger by what floats round.
Bounds box_of(const ShapeInstance& instance, const Bounds& shape) {
  Bounds box;
  for (std::size_t k = 0; k < 3; ++k) {
    float middle = instance.p_FS[k], half = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const float R = instance.R_FS[3 * j + k];
      middle += R * 0.5f * (shape.low[j] + shape.high[j]);
      half += std::fabs(R) * 0.5f * (shape.high[j] - shape.low[j]);
    }
    half += kRounding * (std::fabs(middle) + half);
    box.low[k] = middle - half;
    box.high[k] = middle + half;
  }
  return box;
}

}  // namespace

TriangleIndex triangle_index_of(const Triangles& triangles, std::span<const std::uint32_t> owner) {
  std::vector<Bounds> boxes;
  boxes.reserve(triangles.corner.size());
  for (const auto& corner : triangles.corner) boxes.push_back(box_of(triangles, corner));
  TriangleIndex index;
  index.bvh = bvh_of(boxes, TriangleBlock::kMost);
  for (const Bvh::Leaf& leaf : index.bvh.leaves) {
    TriangleBlock& block = index.blocks.emplace_back();
    block.count = leaf.count;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const std::uint32_t triangle = index.bvh.order[leaf.first + i];
      block.owner[i] = owner.empty() ? 0 : owner[triangle];
      for (std::size_t c = 0; c < 3; ++c) {
        const geom::Vec3& p = triangles.p[triangles.corner[triangle][c]];
        block.p[c][0][i] = static_cast<float>(p.x);
        block.p[c][1][i] = static_cast<float>(p.y);
        block.p[c][2][i] = static_cast<float>(p.z);
      }
    }
  }
  return index;
}

void RayIndex::place_instances() {
  std::vector<Bounds> boxes;
  boxes.reserve(instances.size());
  for (const ShapeInstance& instance : instances)
    boxes.push_back(box_of(instance, shapes[instance.shape].bvh.box));
  placed = bvh_of(boxes, 1);
}

}  // namespace playhouse::arena
