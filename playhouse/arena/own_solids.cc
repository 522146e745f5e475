#include "playhouse/arena/own_solids.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "playhouse/arena/mesh_solids.h"
#include "playhouse/arena/solid_bodies.h"

namespace playhouse::arena {
namespace {

using geom::Pose;
using geom::Vec2;
using geom::Vec3;

constexpr double kTouch = 1e-9;  // m, gap between solids that are merged

struct Stretch {
  double from = 0, to = 0;  // m along a ray
};

/// Intersections of the line with the outlines, by the half-open rule: an even number.
std::vector<double> crossings(const OwnSolid& solid, Vec2 p, Vec2 d) {
  std::vector<double> at;
  for (const std::vector<Vec2>& outline : solid.outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i] - p, b = outline[(i + 1) % outline.size()] - p;
      const double side_a = geom::cross(d, a), side_b = geom::cross(d, b);
      if ((side_a < 0) == (side_b < 0)) continue;
      const double share = side_a / (side_a - side_b);
      at.push_back(geom::dot(d, a) + share * (geom::dot(d, b) - geom::dot(d, a)));
    }
  std::ranges::sort(at);
  return at;
}

/// Interval of the ray within the solid's height range.
Stretch at_height(const OwnSolid& solid, double z, double dz) {
  if (dz == 0) {
    if (z < solid.z_low || z > solid.z_high) return {1, 0};
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  const double low = (solid.z_low - z) / dz, high = (solid.z_high - z) / dz;
  return {std::min(low, high), std::max(low, high)};
}

/// Pose of a model in its tree's root; none if it is tilted or movable against the root.
std::optional<Pose> pose_in_top(const world::Models& models, std::uint32_t row) {
  Pose X_BM;
  for (; models.root[row] != row; row = models.parent[row]) {
    if (world::moves(models.kind[row]) || models.tilt_PM[row] != geom::Tilt{}) return std::nullopt;
    X_BM = geom::compose(models.X_PM[row], X_BM);
  }
  return X_BM;
}

void add(std::vector<double>& key, std::uint32_t desc, const Pose& X_BM) {
  key.insert(key.end(), {static_cast<double>(desc), X_BM.x, X_BM.y, X_BM.z, X_BM.a});
}

std::vector<float> inside_of_rays(const LidarBeams& beams, const std::vector<OwnSolid>& own,
                                  const Pose& X_BM) {
  std::vector<float> inside;
  const geom::Rotation turn = geom::Rotation::of(X_BM.a);
  for (const LidarBeams::Ray& ray : beams.rays) {
    const Vec2 p = X_BM.xy() + turn * Vec2{ray.p.x, ray.p.y}, d = turn * Vec2{ray.d.x, ray.d.y};
    const double far = ray.is_turned ? 0 : inside_of(own, {p.x, p.y, X_BM.z + ray.p.z}, {d.x, d.y, ray.d.z});
    inside.push_back(static_cast<float>(far));
  }
  return inside;
}

}  // namespace

double inside_of(std::span<const OwnSolid> solids, const Vec3& p, const Vec3& d) {
  std::vector<Stretch> stretches;
  for (const OwnSolid& solid : solids) {
    const Stretch height = at_height(solid, p.z, d.z);
    const std::vector<double> at = crossings(solid, {p.x, p.y}, {d.x, d.y});
    const double level = d.x * d.x + d.y * d.y;
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      const Stretch stretch{std::max(at[i] / level, height.from), std::min(at[i + 1] / level, height.to)};
      if (stretch.from < stretch.to) stretches.push_back(stretch);
    }
  }
  double far = 0;
  for (bool longer = true; longer;) {
    longer = false;
    for (const Stretch& stretch : stretches) {
      if (stretch.from > far + kTouch || stretch.to <= far) continue;
      far = stretch.to;
      longer = true;
    }
  }
  return far;
}

std::span<const float> OwnSolids::inside(const world::World& world, const stage::Solids& solids,
                                         std::uint32_t model, const LidarBeams& beams, std::size_t first,
                                         std::size_t last) {
  const world::Models& models = world.models;
  const std::optional<Pose> X_BM = pose_in_top(models, model);
  if (!X_BM) return {};
  std::vector<double> key;
  add(key, models.desc[model], *X_BM);
  for (std::size_t row = first; row < last; ++row) {
    const std::optional<Pose> X_BS = pose_in_top(models, solids.model[row]);
    if (!X_BS || mesh_of(world, solids.model[row]) != nullptr) return {};  // a mesh may be hollow
    if (row == first || solids.model[row] != solids.model[row - 1])
      add(key, models.desc[solids.model[row]], *X_BS);
  }
  const auto [entry, is_new] = known_.try_emplace(std::move(key));
  if (is_new) {
    std::vector<OwnSolid> own;
    each_body(solids, first, last, stage::Observer::kRanger, [&](std::size_t begin, std::size_t end) {
      const Pose X_BS = *pose_in_top(models, solids.model[begin]);
      own.push_back({outlines_of(solids, begin, end, X_BS), X_BS.z + solids.z_min_M[begin],
                     X_BS.z + solids.z_max_M[begin]});
    });
    entry->second = inside_of_rays(beams, own, *X_BM);
  }
  return entry->second;
}

}  // namespace playhouse::arena
