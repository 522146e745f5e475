// Overlap test of a tree to be spawned: by outlines,
// not circles, so that a place beside a wall is free.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "playhouse/bodies/overlap.h"
#include "playhouse/bodies/solids.h"
#include "playhouse/bridge/simulated/joining.h"

namespace playhouse::drivers {
namespace {

using bodies::Solid;

constexpr double kFarthest = 1000;  // m from any model
constexpr double kReach = 2;        // m, in which another place is looked for
constexpr double kStep = 0.05;      // m between the rings of places
constexpr int kBearings = 24;       // of a ring

std::vector<Solid> solids_of(const world::World& world, std::uint32_t prototype, const geom::Pose& X_WM) {
  const std::vector<scene::ModelDesc>& models = world.scene().models;
  std::vector<Solid> solids;
  std::vector<geom::Pose> poses;
  for (std::uint32_t i = 0; i < scene::tree_size(world.scene(), prototype); ++i) {
    const scene::ModelDesc& desc = models[prototype + i];
    poses.push_back(
        i == 0 ? X_WM : geom::compose(poses[static_cast<std::uint32_t>(desc.parent) - prototype], desc.X_PM));
    bodies::add_blocks(desc, poses.back(), solids);
  }
  return solids;
}

/// True if an edge of the loops penetrates the outline, or if that is inside by the even-odd rule.
bool meets_contours(const Solid& solid, const scene::Contours& contours, const geom::Pose& X_WB) {
  if (!bodies::share_heights(solid, X_WB.z + contours.z_min, X_WB.z + contours.z_max)) return false;
  const bodies::Polygon outline = bodies::outline_of(solid);
  const geom::Vec2 inner = solid.p.front();
  bool inside = false;
  for (const std::vector<geom::Vec2>& loop : contours.loops) {
    const std::vector<geom::Vec2> p = bodies::moved(X_WB, loop);
    for (std::size_t i = 0, before = p.size() - 1; i < p.size(); before = i++) {
      const geom::Vec2 a = p[before], b = p[i];
      if (bodies::length_inside(outline, a, b) > 0) return true;
      if (bodies::ray_crosses(inner, a, b)) inside = !inside;
    }
  }
  return inside;
}

geom::Box box_of(std::span<const Solid> solids) {
  geom::Box box;
  for (const Solid& solid : solids)
    for (const geom::Vec2 p : solid.p) box.add(p);
  return box;
}

/// Bounds of what descriptions of models describe, each computed at the first need: many models share one.
class Bounds {
 public:
  explicit Bounds(const scene::SceneDesc& scene) : scene_(scene), squares_(scene.models.size(), kUnknown) {}

  /// Squared distance from the model's origin, within which its body is.  [m^2]
  double square(std::uint32_t desc) {
    if (squares_[desc] == kUnknown) squares_[desc] = square_of(scene_.models[desc]);
    return squares_[desc];
  }

 private:
  static constexpr double kUnknown = -1;

  static double square_of(const scene::ModelDesc& desc) {
    double square = 0;
    const auto add = [&](std::span<const geom::Vec2> points) {
      for (const geom::Vec2 p_B : points) {
        const geom::Vec2 p_M = geom::transform(desc.X_MB, p_B);
        square = std::max(square, geom::dot(p_M, p_M));
      }
    };
    for (const scene::Block& block : desc.blocks) add(block.points);
    for (const scene::Contours& contours : desc.bitmaps)
      for (const std::vector<geom::Vec2>& loop : contours.loops) add(loop);
    const double radius = std::sqrt(square) + bodies::kTouch;
    return radius * radius;
  }

  const scene::SceneDesc& scene_;
  std::vector<double> squares_;  // by row of SceneDesc::models
};

/// What a tree of a prototype could hit at most `reach` from X_WM.  [m]
class Obstacles {
 public:
  Obstacles(const world::World& world, std::uint32_t prototype, const geom::Pose& X_WM, double reach)
      : world_(world), prototype_(prototype) {
    const geom::Box near = box_of(solids_of(world, prototype, X_WM)).grown(reach);
    if (near.empty()) return;
    Bounds bounds(world.scene());
    for (const world::ModelRow row : world.models.rows()) {
      const geom::Pose& X_WO = world.models.X_WM[row];
      const double dx = X_WO.x - std::clamp(X_WO.x, near.x_min, near.x_max),
                   dy = X_WO.y - std::clamp(X_WO.y, near.y_min, near.y_max);
      if (dx * dx + dy * dy > bounds.square(world.models.desc[row])) continue;
      const scene::ModelDesc& desc = world.desc(row);
      std::vector<Solid> solids;
      bodies::add_blocks(desc, world.models.X_WM[row], solids);
      for (Solid& solid : solids)
        if (box_of(std::span(&solid, 1)).overlaps(near)) blocks_.push_back(std::move(solid));
      if (!desc.obstacle_return) continue;
      for (const scene::Contours& contours : desc.bitmaps)
        contours_.push_back({&contours, geom::compose(world.models.X_WM[row], desc.X_MB)});
    }
  }

  bool leave_free(const geom::Pose& X_WM) const {
    return std::ranges::none_of(solids_of(world_, prototype_, X_WM),
                                [this](const Solid& solid) { return are_met_by(solid); });
  }

 private:
  struct Placed {
    const scene::Contours* contours;
    geom::Pose X_WB;
  };

  bool are_met_by(const Solid& solid) const {
    return std::ranges::any_of(blocks_,
                               [&](const Solid& other) {
                                 return bodies::share_heights(solid, other.bottom, other.top) &&
                                        bodies::touch(solid.p, other.p);
                               }) ||
           std::ranges::any_of(contours_, [&](const Placed& placed) {
             return meets_contours(solid, *placed.contours, placed.X_WB);
           });
  }

  const world::World& world_;
  std::uint32_t prototype_;
  std::vector<Solid> blocks_;
  std::vector<Placed> contours_;
};

/// True if no model reaches to within kFarthest of the place.
bool is_far(const world::World& world, const geom::Pose& X_WM) {
  for (const world::ModelRow row : world.models.rows()) {
    const geom::Pose& X_WO = world.models.X_WM[row];
    const geom::Size& size = world.desc(row).size;
    const double dx = std::abs(X_WO.x - X_WM.x), dy = std::abs(X_WO.y - X_WM.y);
    if (std::max(dx, dy) > kFarthest + size.x + size.y) continue;  // most of a large world, without a root
    if (std::hypot(dx, dy) <= kFarthest + std::hypot(size.x, size.y)) return false;
  }
  return world.models.size() != 0;
}

}  // namespace

bool is_free(const world::World& world, std::uint32_t prototype, const geom::Pose& X_WM) {
  return Obstacles(world, prototype, X_WM, 0).leave_free(X_WM);
}

Result<void> check_near(const world::World& world, const geom::Pose& X_WM) {
  if (!is_far(world, X_WM)) return {};
  return Error{"", fmt::format("{:.2f} {:.2f} is more than {:.0f} m from everything in the world", X_WM.x,
                               X_WM.y, kFarthest)};
}

Result<geom::Pose> free_place(const world::World& world, std::uint32_t prototype, const geom::Pose& X_WM) {
  if (const Result<void> near = check_near(world, X_WM); !near) return near.error();
  const Obstacles obstacles(world, prototype, X_WM, kReach);
  if (obstacles.leave_free(X_WM)) return X_WM;
  for (int ring = 1; ring * kStep <= kReach; ++ring)
    for (int i = 0; i < kBearings; ++i) {
      const geom::SinCos bearing = geom::sincos(2 * geom::kPi * i / kBearings);
      geom::Pose X = X_WM;
      X.x += ring * kStep * bearing.cos;
      X.y += ring * kStep * bearing.sin;
      if (obstacles.leave_free(X)) return X;
    }
  return Error{
      "", fmt::format("there is no free place within {:.0f} m of {:.2f} {:.2f}", kReach, X_WM.x, X_WM.y)};
}

}  // namespace playhouse::drivers
