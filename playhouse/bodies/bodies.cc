#include "playhouse/bodies/bodies.h"

#include <algorithm>
#include <cmath>

#include "playhouse/bodies/enclosure.h"
#include "playhouse/bodies/overlap.h"

namespace playhouse::bodies {
namespace {

double signed_area(std::span<const Vec2> polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    doubled += geom::cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * doubled;
}

/// The convex hull, counter-clockwise, without collinear corners (Andrew's monotone chain).
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

/// The smallest distance between parallel supporting lines of the polygon, one along
/// a side of the hull, by rotating calipers: O(n log n) for the hull, O(n) after.
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

SolidShape make_shape(std::span<const Vec2> points_B, double z_min, double z_max,
                      const scene::ModelDesc& desc) {
  const Rotation turn = Rotation::of(desc.X_MB.a);
  const bool reversed = signed_area(points_B) < 0;
  SolidShape shape;
  shape.z_min_M = z_min + desc.X_MB.z;
  shape.z_max_M = z_max + desc.X_MB.z;
  Vec2 sum;
  for (std::size_t i = 0; i < points_B.size(); ++i) {
    const Vec2 p_M = desc.X_MB.xy() + turn * points_B[reversed ? points_B.size() - 1 - i : i];
    shape.p_M.push_back(p_M);
    sum = sum + p_M;
  }
  shape.center_M = (1.0 / static_cast<double>(shape.p_M.size())) * sum;
  double radius_squared = 0;
  for (const Vec2 p : shape.p_M)
    radius_squared = std::max(radius_squared, geom::dot(p - shape.center_M, p - shape.center_M));
  shape.radius = std::sqrt(radius_squared);
  shape.width = width_of(shape.p_M);
  shape.convex = is_convex(shape.p_M);
  shape.p_M.push_back(shape.p_M.front());
  return shape;
}

void add_solid(Solids& solids, const SolidShape& shape, const scene::ModelDesc& desc, world::ModelRow model,
               world::ModelRow root, TreeRow tree, SolidRow first) {
  solids.model.push_back(model);
  solids.root.push_back(root);
  solids.tree.push_back(tree);
  solids.z_min_M.push_back(shape.z_min_M);
  solids.z_max_M.push_back(shape.z_max_M);
  solids.center_M.push_back(shape.center_M);
  solids.radius.push_back(shape.radius);
  solids.width.push_back(shape.width);
  solids.convex.push_back(shape.convex);
  solids.full.push_back(shape.full);
  solids.hole.push_back(shape.hole);
  solids.body.push_back(first + shape.body.index);
  solids.seen_by.push_back(seen_by_of(desc));
  solids.enclosed.push_back(0);
  solids.p_M.insert(solids.p_M.end(), shape.p_M.begin(), shape.p_M.end());
  solids.first_vertex.push_back(solids.p_M.next());
}

void add_model_solids(Solids& solids, const world::World& world, Shapes& shapes, world::ModelRow model,
                      TreeRow tree) {
  const scene::ModelDesc& desc = world.desc(model);
  const SolidRow first = solids.model.next();
  for (const SolidShape& shape : shapes.of(world.models.desc[model]))
    add_solid(solids, shape, desc, model, world.models.root[model], tree, first);
}

/// Copies the corners of p relative to the center into columns.
void put_corners(Solids& solids, SolidRow row) {
  constexpr std::size_t kEight = EightCorners::kCorners;
  const std::size_t count = solids.convex_corners(row);
  const Vec2* const p = solids.p.from(solids.first_vertex[row]);
  const Vec2 center = solids.center[row];
  CornersRow next = solids.first_corners[solids.place_of(row)];
  for (std::size_t first = 0; first < count; first += kEight, ++next) {
    EightCorners& eight = solids.corners[next];
    for (std::size_t i = 0; i < kEight; ++i) {
      const Vec2 corner = p[first + i < count ? first + i : 0];
      eight.x[i] = static_cast<float>(corner.x - center.x);
      eight.y[i] = static_cast<float>(corner.y - center.y);
    }
  }
}

/// Allocates the corner columns of movable solids.
void make_room_for_corners(Solids& solids) {
  CornersRow next{0};
  solids.first_corners.clear();
  for (const SolidRow row : solids.moving_rows()) {
    solids.first_corners.push_back(next);
    next = next + static_cast<std::uint32_t>((solids.convex_corners(row) + EightCorners::kCorners - 1) /
                                             EightCorners::kCorners);
  }
  solids.corners.resize(next.index);
}

/// Sizes the placement columns and places these solids, the last ones.
void put_in_place(Solids& solids, const world::Models& models, SolidRows rows) {
  solids.center.resize(solids.size());
  solids.z_min.resize(solids.size());
  solids.z_max.resize(solids.size());
  solids.p.resize(solids.p_M.size() + Solids::kPad);
  make_room_for_corners(solids);
  solids.rotation.resize(models.size());
  for (const world::ModelRow model : models.rows()) turn(solids, models, {&model, 1});
  place(solids, models, rows);
}

bool stands_still(const world::Models& models, world::ModelRow row) {
  return models.mobility[row] == world::Mobility::kFixed;
}

/// Appends a model and all attached to it, parents first.
void add_tree(Trees& trees, const world::World& world, world::ModelRow row) {
  const world::Models& models = world.models;
  trees.models.push_back(row);
  if (world::moves(models.kind[row])) trees.movers.push_back({row, models.part[row], models.kind[row]});
  for (const world::ModelRow child : world.children(row)) add_tree(trees, world, child);
}

}  // namespace

const ByRow<SolidShape, SolidShape>& Shapes::of(std::uint32_t row) {
  const auto [entry, is_new] = made_.try_emplace(row);
  if (!is_new) return entry->second;
  const scene::ModelDesc& desc = scene_.models[row];
  ByRow<SolidShape, SolidShape>& shapes = entry->second;
  for (const scene::Block& block : desc.blocks) {
    if (block.points.size() < 3) continue;
    SolidShape shape = make_shape(block.points, block.z_min, block.z_max, desc);
    shape.full = true;
    shape.body = shapes.next();
    shapes.push_back(std::move(shape));
  }
  for (const scene::Contours& bitmap : desc.bitmaps) {
    const Row<SolidShape> body = shapes.next();
    for (const std::vector<Vec2>& loop : bitmap.loops) {
      if (loop.size() < 3) continue;
      SolidShape shape = make_shape(loop, bitmap.z_min, bitmap.z_max, desc);
      shape.hole = signed_area(loop) < 0;
      shape.body = body;
      shapes.push_back(std::move(shape));
    }
  }
  return shapes;
}

Trees make_trees(const world::World& world) {
  const world::Models& models = world.models;
  world::ByModel<std::uint8_t> can_move(models.size());  // of roots: some model of the tree is movable
  for (const world::ModelRow row : models.rows())
    if (!stands_still(models, row)) can_move[models.root[row]] = 1;
  Trees trees;
  trees.first_model.push_back(0);
  trees.first_mover.push_back(trees.movers.next());
  for (const world::ModelRow row : models.rows()) {
    if (!can_move[row]) continue;
    trees.root.push_back(row);
    add_tree(trees, world, row);
    trees.first_model.push_back(static_cast<std::uint32_t>(trees.models.size()));
    trees.first_mover.push_back(trees.movers.next());
  }
  return trees;
}

std::vector<StaticModel> static_models(const world::World& world) {
  const world::Models& models = world.models;
  std::vector<StaticModel> all;
  for (const world::ModelRow row : models.rows())
    if (stands_still(models, row))
      all.push_back({row, models.root[row], models.desc[row], models.X_WM[row], models.tilt_WM[row]});
  return all;
}

Solids make_fixed_solids(const world::World& world, Shapes& shapes) {
  Solids solids;
  solids.first_vertex.push_back(solids.p_M.next());
  for (const world::ModelRow row : world.models.rows())
    if (stands_still(world.models, row)) add_model_solids(solids, world, shapes, row, TreeRow{});
  solids.first_moving = solids.model.next();
  put_in_place(solids, world.models, solids.fixed_rows());
  return solids;
}

void replace_moving_solids(Solids& solids, const world::World& world, Shapes& shapes, Trees& trees) {
  const std::size_t fixed = solids.fixed_rows().size();
  for (auto* column : {&solids.model, &solids.root}) column->resize(fixed);
  solids.tree.resize(fixed);
  solids.body.resize(fixed);
  for (auto* column : {&solids.z_min_M, &solids.z_max_M, &solids.radius, &solids.width, &solids.enclosed})
    column->resize(fixed);
  for (auto* column : {&solids.convex, &solids.full, &solids.hole}) column->resize(fixed);
  solids.seen_by.resize(fixed);
  solids.center_M.resize(fixed);
  solids.first_vertex.resize(fixed + 1);
  solids.p_M.resize(solids.first_vertex.back().index);
  trees.first_solid.assign(1, solids.first_moving);
  for (const TreeRow tree : trees.rows()) {
    for (const world::ModelRow model : trees.models_of(tree))
      if (!stands_still(world.models, model)) add_model_solids(solids, world, shapes, model, tree);
    trees.first_solid.push_back(solids.model.next());
    find_enclosed(solids, world.models, trees.solids_of(tree));
  }
  put_in_place(solids, world.models, solids.moving_rows());
}

void turn(Solids& solids, const world::Models& models, std::span<const world::ModelRow> tree) {
  for (const world::ModelRow model : tree) solids.rotation[model] = Rotation::of(models.X_WM[model].a);
}

void place(Solids& solids, const world::Models& models, SolidRows rows) {
  for (const SolidRow row : rows) {
    const Pose& X_WM = models.X_WM[solids.model[row]];
    const Rotation rotation = solids.rotation[solids.model[row]];
    solids.center[row] = X_WM.xy() + rotation * solids.center_M[row];
    solids.z_min[row] = X_WM.z + solids.z_min_M[row];
    solids.z_max[row] = X_WM.z + solids.z_max_M[row];
    for (const VertexRow v : solids.vertices_of(row)) solids.p[v] = X_WM.xy() + rotation * solids.p_M[v];
    if (row >= solids.first_moving) put_corners(solids, row);
  }
}

}  // namespace playhouse::bodies
