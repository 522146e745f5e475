#include "playhouse/stage/bodies.h"

#include <algorithm>
#include <cmath>

namespace playhouse::stage {
namespace {

constexpr std::uint32_t kNone = world::ModelRow::kNone;

double signed_area(std::span<const Vec2> polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    doubled += geom::cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * doubled;
}

/// Every corner of the counter-clockwise polygon turns left, and it goes round once.
bool is_convex(std::span<const Vec2> polygon) {
  const std::size_t n = polygon.size();
  int upward_turns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = polygon[(i + 1) % n] - polygon[i];
    const Vec2 out = polygon[(i + 2) % n] - polygon[(i + 1) % n];
    if (geom::cross(in, out) < 0) return false;
    if (in.y < 0 && out.y >= 0) ++upward_turns;
  }
  return upward_turns <= 1;
}

/// The corners of the convex hull, counter-clockwise, without those on a side (Andrew's monotone chain).
std::vector<Vec2> convex_hull(std::span<const Vec2> polygon) {
  std::vector<Vec2> points(polygon.begin(), polygon.end());
  std::ranges::sort(points, [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec2> hull;
  const auto add_chain = [&hull](auto first, const auto last) {
    const std::size_t begin = hull.size();
    for (; first != last; ++first) {
      const Vec2 p = *first;
      while (hull.size() >= begin + 2 &&
             geom::cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the next chain begins with it
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

/// The smallest distance between two parallel lines, one along a side of the hull, that hold the polygon. The
/// farthest corner goes round with the side (rotating calipers), so the cost is that of sorting.
double width_of(std::span<const Vec2> polygon) {
  const std::vector<Vec2> hull = convex_hull(polygon);
  if (hull.size() < 3) return 0;
  const auto corner = [&hull](std::size_t i) { return hull[i % hull.size()]; };
  double width = 1e300;
  for (std::size_t i = 0, far = 1; i < hull.size(); ++i) {
    const Vec2 e = corner(i + 1) - hull[i];
    const auto height = [&](std::size_t k) { return geom::cross(e, corner(k) - hull[i]); };
    while (height(far + 1) > height(far)) ++far;
    width = std::min(width, height(far) / std::sqrt(geom::dot(e, e)));
  }
  return width;
}

void add_solid(Solids& solids, std::span<const Vec2> points_B, double z_min, double z_max,
               const scene::ModelDesc& desc, std::uint32_t model, std::uint32_t root, std::uint32_t tree) {
  const Rotation turn = Rotation::of(desc.X_MB.a);
  const std::size_t first = solids.p_M.size();
  const bool reversed = signed_area(points_B) < 0;
  Vec2 sum;
  for (std::size_t i = 0; i < points_B.size(); ++i) {
    const Vec2 p_M = desc.X_MB.xy() + turn * points_B[reversed ? points_B.size() - 1 - i : i];
    solids.p_M.push_back(p_M);
    sum = sum + p_M;
  }
  const std::vector<Vec2> polygon(solids.p_M.begin() + static_cast<std::ptrdiff_t>(first), solids.p_M.end());
  const Vec2 center = (1.0 / static_cast<double>(polygon.size())) * sum;
  double radius_squared = 0;
  for (const Vec2 p : polygon) radius_squared = std::max(radius_squared, geom::dot(p - center, p - center));

  solids.p_M.push_back(solids.p_M[first]);

  solids.model.push_back(model);
  solids.root.push_back(root);
  solids.tree.push_back(tree);
  solids.z_min_M.push_back(z_min + desc.X_MB.z);
  solids.z_max_M.push_back(z_max + desc.X_MB.z);
  solids.center_M.push_back(center);
  solids.radius.push_back(std::sqrt(radius_squared));
  solids.width.push_back(tree == kNone ? 0 : width_of(polygon));  // only what moves needs it
  solids.convex.push_back(is_convex(polygon));
  solids.obstacle.push_back(desc.obstacle_return);
  solids.ranger_return.push_back(desc.ranger_return);
  solids.first_vertex.push_back(static_cast<std::uint32_t>(solids.p_M.size()));
}

void add_model_solids(Solids& solids, const world::World& world, std::uint32_t model, std::uint32_t tree) {
  const scene::ModelDesc& desc = world.desc({model});
  const std::uint32_t root = world.models.root[model];
  for (const scene::Block& block : desc.blocks)
    if (block.points.size() >= 3)
      add_solid(solids, block.points, block.z_min, block.z_max, desc, model, root, tree);
  for (const scene::Contours& bitmap : desc.bitmaps)
    for (const std::vector<Vec2>& loop : bitmap.loops)
      if (loop.size() >= 3) add_solid(solids, loop, bitmap.z_min, bitmap.z_max, desc, model, root, tree);
}

}  // namespace

Trees make_trees(const world::World& world) {
  const world::Models& models = world.models;
  Trees trees;
  trees.of_root.assign(models.size(), kNone);
  std::vector<std::uint8_t> drives(models.size(), 0);
  for (const world::ModelRow model : world.positions.model) drives[models.root[model.index]] = 1;
  for (std::uint32_t row = 0; row < models.size(); ++row) {
    if (models.root[row] != row || !drives[row]) continue;
    trees.of_root[row] = static_cast<std::uint32_t>(trees.root.size());
    trees.root.push_back(row);
  }

  // Models of a tree in row order, by counting.
  const auto count_up = [](std::vector<std::uint32_t>& first) {
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  };
  trees.first_model.assign(trees.size() + 1, 0);
  trees.first_position.assign(trees.size() + 1, 0);
  for (std::uint32_t row = 0; row < models.size(); ++row) {
    const std::uint32_t tree = trees.of_root[models.root[row]];
    if (tree == kNone) continue;
    ++trees.first_model[tree + 1];
    if (models.kind[row] == scene::ModelKind::kPosition) ++trees.first_position[tree + 1];
  }
  count_up(trees.first_model);
  count_up(trees.first_position);
  trees.models.resize(trees.first_model.back());
  trees.positions.resize(trees.first_position.back());
  std::vector<std::uint32_t> next_model(trees.first_model), next_position(trees.first_position);
  for (std::uint32_t row = 0; row < models.size(); ++row) {
    const std::uint32_t tree = trees.of_root[models.root[row]];
    if (tree == kNone) continue;
    trees.models[next_model[tree]++] = row;
    if (models.kind[row] == scene::ModelKind::kPosition)
      trees.positions[next_position[tree]++] = models.part[row];
  }
  return trees;
}

Solids make_solids(const world::World& world, Trees& trees) {
  Solids solids;
  solids.first_vertex.push_back(0);
  trees.first_solid.assign(1, 0);
  for (std::uint32_t tree = 0; tree < trees.size(); ++tree) {
    for (std::uint32_t i = trees.first_model[tree]; i < trees.first_model[tree + 1]; ++i)
      add_model_solids(solids, world, trees.models[i], tree);
    trees.first_solid.push_back(static_cast<std::uint32_t>(solids.size()));
  }
  solids.moving = solids.size();
  for (std::uint32_t row = 0; row < world.models.size(); ++row)
    if (trees.of_root[world.models.root[row]] == kNone) add_model_solids(solids, world, row, kNone);

  solids.center.resize(solids.size());
  solids.z_min.resize(solids.size());
  solids.z_max.resize(solids.size());
  solids.p.resize(solids.p_M.size() + Solids::kSpare);
  place(solids, world.models, 0, solids.size());
  return solids;
}

void place(Solids& solids, const world::Models& models, std::size_t begin, std::size_t end) {
  std::uint32_t model = kNone;
  Rotation rotation;
  for (std::size_t row = begin; row < end; ++row) {
    if (solids.model[row] != model) {
      model = solids.model[row];
      rotation = Rotation::of(models.X_WM[model].a);
    }
    const Pose& X_WM = models.X_WM[model];
    solids.center[row] = X_WM.xy() + rotation * solids.center_M[row];
    solids.z_min[row] = X_WM.z + solids.z_min_M[row];
    solids.z_max[row] = X_WM.z + solids.z_max_M[row];
    for (std::uint32_t v = solids.first_vertex[row]; v < solids.first_vertex[row + 1]; ++v)
      solids.p[v] = X_WM.xy() + rotation * solids.p_M[v];
  }
}

}  // namespace playhouse::stage
