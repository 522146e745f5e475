#include "playhouse/arena/sensing/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "playhouse/base/assert.h"

namespace playhouse::arena {
namespace {

/// The middle of the points in whole steps, so that worlds about the origin have it as theirs.  [m]
geom::Vec3 origin_about(std::span<const geom::Vec3> points) {
  constexpr double kStep = 1024;
  geom::Vec3 low = points.front(), high = low;
  for (const geom::Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto middle = [](double a, double b) { return kStep * std::round(0.5 * (a + b) / kStep); };
  return {middle(low.x, high.x), middle(low.y, high.y), middle(low.z, high.z)};
}

}  // namespace

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
  index_.p_WF = all.p.empty() ? geom::Vec3{} : origin_about(all.p);
  for (geom::Vec3& p : all.p) p = p - index_.p_WF;
  index_.fixed = triangle_index_of(all, owner);
  index_.fixed_owners.assign(owners.begin(), owners.end());
}

std::uint32_t RayScene::add_shape(const Triangles& triangles) {
  index_.shapes.push_back(triangle_index_of(triangles, {}));
  return static_cast<std::uint32_t>(index_.shapes.size() - 1);
}

void RayScene::set_instances(std::span<const OwnedShape> instances) {
  index_.instances.clear();
  for (const OwnedShape& instance : instances)
    index_.instances.push_back({.shape = instance.shape, .owner = instance.owner});
}

void RayScene::place(std::uint32_t instance, const geom::Vec3& p, const geom::Quaternion& q) {
  ShapeInstance& placed = index_.instances[instance];
  const geom::Vec3 x = q * geom::Vec3{1, 0, 0}, y = q * geom::Vec3{0, 1, 0}, z = q * geom::Vec3{0, 0, 1};
  float* out = placed.R_FS.data();
  for (const geom::Vec3& column : {x, y, z})
    for (const double c : {column.x, column.y, column.z}) *out++ = static_cast<float>(c);
  index_.put(p, placed.p_FS.data());
}

}  // namespace playhouse::arena
