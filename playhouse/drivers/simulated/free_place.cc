// Overlap test of a robot to be spawned: by outlines,
// not circles, so that a place beside a wall is free.

#include <algorithm>
#include <span>
#include <vector>

#include "playhouse/drivers/simulated/joining.h"
#include "playhouse/stage/overlap.h"
#include "playhouse/stage/solids.h"

namespace playhouse::drivers {
namespace {

using stage::Solid;

std::vector<Solid> solids_of(const world::World& world, std::uint32_t prototype, const geom::Pose& X_WM) {
  const std::vector<scene::ModelDesc>& models = world.scene().models;
  std::vector<Solid> solids;
  std::vector<geom::Pose> poses;
  for (std::uint32_t i = 0; i < scene::tree_size(world.scene(), prototype); ++i) {
    const scene::ModelDesc& desc = models[prototype + i];
    poses.push_back(
        i == 0 ? X_WM : geom::compose(poses[static_cast<std::uint32_t>(desc.parent) - prototype], desc.X_PM));
    stage::add_blocks(desc, poses.back(), solids);
  }
  return solids;
}

bool meets_blocks(const Solid& solid, std::span<const Solid> others) {
  return std::ranges::any_of(others, [&](const Solid& other) {
    return stage::share_heights(solid, other.bottom, other.top) && stage::touch(solid.p, other.p);
  });
}

/// True if an edge of the loops penetrates the outline, or if that is inside by the even-odd rule.
bool meets_contours(const Solid& solid, const scene::Contours& contours, const geom::Pose& X_WB) {
  if (!stage::share_heights(solid, X_WB.z + contours.z_min, X_WB.z + contours.z_max)) return false;
  const stage::Outline outline = stage::outline_of(solid);
  const geom::Vec2 inner = solid.p.front();
  bool inside = false;
  for (const std::vector<geom::Vec2>& loop : contours.loops) {
    const std::vector<geom::Vec2> p = stage::moved(X_WB, loop);
    for (std::size_t i = 0, before = p.size() - 1; i < p.size(); before = i++) {
      const geom::Vec2 a = p[before], b = p[i];
      if (stage::length_inside(outline, a, b) > 0) return true;
      if (stage::ray_crosses(inner, a, b)) inside = !inside;
    }
  }
  return inside;
}

}  // namespace

bool is_free(const world::World& world, std::uint32_t prototype, const geom::Pose& X_WM) {
  const std::vector<Solid> robot = solids_of(world, prototype, X_WM);
  std::vector<Solid> others;
  for (std::uint32_t row = 0; row < world.models.size(); ++row) {
    const scene::ModelDesc& desc = world.desc({row});
    const geom::Pose& X_WO = world.models.X_WM[row];
    stage::add_blocks(desc, X_WO, others);
    if (!desc.obstacle_return) continue;
    const geom::Pose X_WB = geom::compose(X_WO, desc.X_MB);
    for (const scene::Contours& contours : desc.bitmaps)
      for (const Solid& solid : robot)
        if (meets_contours(solid, contours, X_WB)) return false;
  }
  return std::ranges::none_of(robot, [&](const Solid& solid) { return meets_blocks(solid, others); });
}

}  // namespace playhouse::drivers
