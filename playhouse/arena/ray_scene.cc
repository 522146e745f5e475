#include "playhouse/arena/ray_scene.h"

#include <vector>

#include "playhouse/base/assert.h"

namespace playhouse::arena {

void RayScene::set_fixed(std::span<const Triangles> fixed, std::span<const Owner> owners) {
  PLAYHOUSE_ASSERT(fixed.size() == owners.size());
  Triangles all;
  std::vector<std::uint32_t> owner;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(all.p.size());
    all.p.insert(all.p.end(), fixed[i].p.begin(), fixed[i].p.end());
    for (const auto& corner : fixed[i].corner)
      all.corner.push_back({first + corner[0], first + corner[1], first + corner[2]});
    owner.resize(all.corner.size(), static_cast<std::uint32_t>(i));
  }
  index_.fixed = triangle_index_of(all, owner);
  index_.fixed_owners.assign(owners.begin(), owners.end());
}

std::uint32_t RayScene::add_shape(const Triangles& triangles) {
  index_.shapes.push_back(triangle_index_of(triangles, {}));
  return static_cast<std::uint32_t>(index_.shapes.size() - 1);
}

void RayScene::set_instances(std::span<const Instance> instances) {
  index_.instances.clear();
  for (const Instance& instance : instances)
    index_.instances.push_back({.shape = instance.shape, .owner = instance.owner});
}

void RayScene::place(std::uint32_t instance, const geom::Vec3& p, const geom::Quaternion& q) {
  ShapeInstance& placed = index_.instances[instance];
  const geom::Vec3 x = q * geom::Vec3{1, 0, 0}, y = q * geom::Vec3{0, 1, 0}, z = q * geom::Vec3{0, 0, 1};
  float* out = placed.R_WS.data();
  for (const geom::Vec3& column : {x, y, z})
    for (const double c : {column.x, column.y, column.z}) *out++ = static_cast<float>(c);
  placed.p_WS = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

}  // namespace playhouse::arena
