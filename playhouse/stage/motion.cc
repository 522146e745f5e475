#include "playhouse/stage/motion.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "playhouse/base/limits.h"
#include "playhouse/bodies/generated/moves.h"

namespace playhouse::stage {
namespace {

constexpr double kRounding = 1e-9;  // m; tolerance for a deeper penetration

bool is_moving(const world::World& world, const bodies::Mover& mover) {
  return bodies::with_move(mover.kind, [&](auto move) { return move.is_moving(world, mover.part); });
}

double distance(geom::Vec2 a, geom::Vec2 b) {
  return std::sqrt(geom::dot(b - a, b - a));
}

struct HeightRange {
  double z_min, z_max;  // m
};

/// The pose of a mover after this tick; X_PM is the present one.
geom::Pose moved_by(const world::World& world, const bodies::Mover& mover, const geom::Pose& X_PM) {
  const double dt = world.scene().interval;
  return bodies::with_move(mover.kind, [&](auto move) { return move.after(world, mover.part, X_PM, dt); });
}

template <typename A, typename B>
bool z_overlaps(const A& a, const B& b) {
  return a.z_min < b.z_max - bodies::kTouch && b.z_min < a.z_max - bodies::kTouch;
}

geom::Pose part_at(const geom::Pose& X_WP, geom::Rotation rotation, const geom::Pose& X_PM) {
  const geom::Vec2 p = X_WP.xy() + rotation * X_PM.xy();
  return {p.x, p.y, X_WP.z + X_PM.z, geom::normalize(X_WP.a + X_PM.a)};
}

bodies::Polygon outline_at(const bodies::Solids& solids, bodies::SolidRow row, geom::Vec2 center,
                           const geom::Vec2* p) {
  return {{p, solids.corners_of(row)}, center, solids.convex[row] != 0};
}

/// Height range of a solid in a configuration; `first` is its tree's first solid.
HeightRange heights_in(const bodies::Solids& solids, bodies::SolidRow row, const bodies::TreeShape& shape,
                       bodies::SolidRow first) {
  if (shape.z.empty()) return {solids.z_min[row], solids.z_max[row]};
  const double z = shape.z[row - first];
  return {z + solids.z_min_M[row], z + solids.z_max_M[row]};
}

bodies::Polygon outline_now(const bodies::Solids& solids, bodies::SolidRow row) {
  return outline_at(solids, row, solids.center[row], solids.p.from(solids.first_vertex[row]));
}

}  // namespace

Motion::PlacedSolid Motion::solid_now(const bodies::Solids& solids, bodies::SolidRow row) {
  return {outline_now(solids, row), solids.z_min[row], solids.z_max[row]};
}

Motion::PlacedSolid Motion::proposed(const bodies::Solids& solids, bodies::SolidRow row) const {
  PlacedSolid body = solid_now(solids, row);
  body.outline = outline_at(solids, row, center_[place_of(row)], p_.data() + vertex_of(solids, row));
  if (!lifts_[solids.tree[row]]) return body;
  const double z = z_[place_of(row)];
  return {body.outline, z + solids.z_min_M[row], z + solids.z_max_M[row]};
}

void Motion::populate(const bodies::Trees& trees, const bodies::Solids& solids, const world::Models& models) {
  trees_ = &trees;
  first_moving_ = solids.first_moving;
  first_moving_vertex_ = solids.first_vertex[solids.first_moving];
  headroom_.populate(trees, solids, models);
  proposes_.assign(trees.size(), 0);
  stalls_.assign(trees.size(), 0);
  free_.assign(trees.size(), 0);
  lifts_.assign(trees.size(), 0);
  conflicts_.assign(trees.size(), {});
  way_.assign(trees.size(), 0);
  reach_.assign(trees.size(), 0);
  first_parent_.assign(trees.size(), world::ModelRow::kNone);
  parent_.clear();
  std::size_t largest_tree = 0, most_solids = 0, most_vertices = 0;
  for (const bodies::TreeRow tree : trees.rows()) {
    add_parents(trees.models_of(tree), models, tree);
    const bodies::SolidRow first = trees.first_solid[tree], last = trees.first_solid[tree + 1];
    largest_tree = std::max<std::size_t>(largest_tree, trees.models_of(tree).size());
    most_solids = std::max<std::size_t>(most_solids, last - first);
    most_vertices =
        std::max<std::size_t>(most_vertices, solids.first_vertex[last] - solids.first_vertex[first]);
  }
  for (Sweep& sweep : sweeps_) {
    sweep.moved.resize(largest_tree);
    sweep.X_WM.resize(largest_tree);
    sweep.rotation.resize(largest_tree);
    sweep.center.resize(most_solids);
    sweep.z.resize(most_solids);
    sweep.p.resize(most_vertices);
    sweep.near.clear();
    sweep.near.reserve(solids.moving());
    sweep.conflicts.clear();
    sweep.conflicts.reserve(8 * trees.size());  // work is unevenly shared: one sweep may get it all
  }
  moved_.resize(trees.movers.size());
  rotation_.resize(trees.size());
  center_.resize(solids.moving());
  z_.resize(solids.moving());
  p_.resize(solids.p_M.next() - first_moving_vertex_);
}

void Motion::add_parents(std::span<const world::ModelRow> rows, const world::Models& models,
                         bodies::TreeRow tree) {
  bool is_run = true;
  for (std::size_t i = 0; i < rows.size(); ++i) is_run = is_run && rows[i] - rows[0] == i;
  if (is_run) return;
  first_parent_[tree] = static_cast<std::uint32_t>(parent_.size());
  std::map<world::ModelRow, std::uint32_t> place;  // of a model: its row in its tree
  for (const world::ModelRow row : rows) {
    parent_.push_back(place.empty() ? 0 : place.at(models.parent[row]));
    place.emplace(row, static_cast<std::uint32_t>(place.size()));
  }
}

bodies::TreeShape Motion::proposal(const bodies::Solids& solids, bodies::TreeRow tree, Sweep& sweep) {
  const std::size_t models = trees_->models_of(tree).size();
  const bodies::SolidRow solid = trees_->first_solid[tree], last = trees_->first_solid[tree + 1];
  return {{moved_.data() + trees_->first_mover[tree].index, trees_->movers_of(tree).size()},
          {sweep.X_WM.data(), models},
          {sweep.rotation.data(), models},
          {center_.data() + place_of(solid), last - solid},
          {p_.data() + vertex_of(solids, solid), solids.first_vertex[last] - solids.first_vertex[solid]},
          {z_.data() + place_of(solid), lifts_[tree] ? last - solid : 0}};
}

/// The configuration of a tree after `fraction` of this tick's motion.
void Motion::shape_at(const Inputs& in, bodies::TreeRow tree, double fraction,
                      const bodies::TreeShape& out) const {
  const world::Models& models = in.world.models;
  const double dt = in.world.scene().interval * fraction;
  const std::span<const world::ModelRow> rows = trees_->models_of(tree);
  const std::span<const bodies::Mover> movers = trees_->movers_of(tree);
  std::size_t next = 0;  // of movers
  for (std::size_t i = 0; i < out.X_WM.size(); ++i) {
    const world::ModelRow model = rows[i];
    const geom::Pose* X_PM = &models.X_PM[model];
    if (next < movers.size() && movers[next].model == model) {
      const bodies::Mover& mover = movers[next];
      geom::Pose& X = out.moved[next++];
      X = bodies::with_move(mover.kind,
                            [&](auto move) { return move.after(in.world, mover.part, *X_PM, dt); });
      X_PM = &X;
    }
    if (i == 0) {
      out.X_WM[0] = *X_PM;
      out.rotation[0] = geom::Rotation::of(out.X_WM[0].a);
      continue;
    }
    const std::uint32_t parent = parent_of(models, tree, model, i);
    out.X_WM[i] = part_at(out.X_WM[parent], out.rotation[parent], *X_PM);
    out.rotation[i] = X_PM->a == 0 ? out.rotation[parent] : geom::Rotation::of(out.X_WM[i].a);
  }

  const bodies::Solids& solids = in.solids;
  const bodies::SolidRows own = trees_->solids_of(tree);
  std::size_t local = 0, vertex = 0;
  for (const bodies::SolidRow row : own) {
    while (rows[local] != solids.model[row]) ++local;
    const geom::Vec2 p = out.X_WM[local].xy();
    const geom::Rotation rotation = out.rotation[local];
    out.center[row - own.front()] = p + rotation * solids.center_M[row];
    if (!out.z.empty()) out.z[row - own.front()] = out.X_WM[local].z;
    for (const bodies::VertexRow v : solids.vertices_of(row)) out.p[vertex++] = p + rotation * solids.p_M[v];
  }
}

/// For a rigid tree only its root pose, enough to bound the displacement of its solids.
void Motion::propose(const Inputs& in, bodies::TreeRow tree, Sweep& sweep) {
  proposes_[tree] = stalls_[tree] = lifts_[tree] = free_[tree] = 0;
  reach_[tree] = 0;
  for (const bodies::Mover& mover : trees_->movers_of(tree)) {
    if (!is_moving(in.world, mover)) continue;
    proposes_[tree] = 1;
    if (bodies::with_move(mover.kind, [&](auto move) { return move.changes_height(in.world, mover.part); }))
      lifts_[tree] = 1;
  }
  if (!proposes_[tree]) return;
  if (headroom_.is_rigid(tree) && !lifts_[tree]) {
    const geom::Pose& X_WM = in.world.models.X_PM[trees_->root[tree]];
    const geom::Pose& moved = moved_[trees_->first_mover[tree]] =
        moved_by(in.world, trees_->movers_of(tree)[0], X_WM);
    way_[tree] = distance(X_WM.xy(), moved.xy());
    reach_[tree] =
        way_[tree] + std::fabs(geom::normalize(moved.a - X_WM.a)) * headroom_.arm(tree) + kRounding;
    return;
  }
  const bodies::TreeShape shape = propose_shape(in, tree, sweep);
  const bodies::SolidRows rows = trees_->solids_of(tree);
  for (const bodies::SolidRow row : rows)
    reach_[tree] = std::max(reach_[tree], distance(shape.center[row - rows.front()], in.solids.center[row]));
}

bodies::TreeShape Motion::propose_shape(const Inputs& in, bodies::TreeRow tree, Sweep& sweep) {
  const bodies::TreeShape shape = proposal(in.solids, tree, sweep);
  shape_at(in, tree, 1.0, shape);
  rotation_[tree] = shape.rotation[0];
  return shape;
}

/// Completes the proposal of a rigid tree without headroom.
void Motion::propose_rest(const Inputs& in, bodies::TreeRow tree, Sweep& sweep) {
  if (!headroom_.is_rigid(tree) || lifts_[tree]) return;
  const double way = way_[tree];
  free_[tree] = headroom_.spend(tree, way);
  if (!free_[tree]) {
    const geom::Vec2 p = in.world.models.X_WM[trees_->root[tree]].xy();
    headroom_.measure(tree, p, way, in.solids, in.index, in.walls);
    headroom_.avoid(tree, p, fast_);
    free_[tree] = headroom_.spend(tree, way);
  }
  if (free_[tree])
    rotation_[tree] = geom::Rotation::of(moved_[trees_->first_mover[tree]].a);
  else
    propose_shape(in, tree, sweep);
}

/// Number of substeps such that no solid moves by more than half its width per substep: no tunnelling.
unsigned Motion::steps_of(const Inputs& in, bodies::TreeRow tree) const {
  const double dt = in.world.scene().interval;
  double turn = 0;
  for (const bodies::Mover& mover : trees_->movers_of(tree))
    turn +=
        bodies::with_move(mover.kind, [&](auto move) { return move.turn_rate(in.world, mover.part); }) * dt;
  // A full turn of a joint in a tick has a large path but a small displacement.
  const auto swing = [&](geom::Vec2 center) {
    double way = 0;
    for (const bodies::Mover& mover : trees_->movers_of(tree))
      way +=
          bodies::with_move(mover.kind, [&](auto move) { return move.swing(in.world, mover.part, center); }) *
          dt;
    return way;
  };
  double steps = 1;
  for (const bodies::SolidRow row : trees_->solids_of(tree)) {
    if (!in.solids.is_obstacle(row)) continue;
    const double way = distance(center_[place_of(row)], in.solids.center[row]) +
                       turn * in.solids.radius[row] + swing(in.solids.center[row]);
    steps = std::max(steps, way / std::max(0.5 * in.solids.width[row], bodies::kTouch));
    if (!lifts_[tree]) continue;
    const double height = in.solids.z_max[row] - in.solids.z_min[row];
    steps = std::max(steps, rise_of(in.solids, row) / std::max(0.5 * height, bodies::kTouch));
  }
  return static_cast<unsigned>(std::ceil(std::min(steps, static_cast<double>(limits::kMotionSteps))));
}

/// True if the outline penetrates a wall deeper than before.
bool Motion::meets_wall(const Inputs& in, bodies::SolidRow solid, const PlacedSolid& now,
                        const PlacedSolid& then) const {
  const double radius = in.solids.radius[solid];
  const geom::Vec2 center = then.outline.center;
  if (in.walls.clear_about(center) > radius) return false;
  const geom::Box box = bodies::box_about(center, radius);
  bool met = false;
  in.walls.near(box, [&](const bodies::Walls::Edge& edge) {
    if (met || !in.solids.is_obstacle(edge.solid) || !edge.reaches(box)) return;
    const HeightRange wall{in.solids.z_min[edge.solid], in.solids.z_max[edge.solid]};
    if (!z_overlaps(then, wall) || in.solids.root[edge.solid] == in.solids.root[solid]) return;
    const double inside = length_inside(then.outline, edge.a, edge.b);
    met = inside > kRounding &&
          !(z_overlaps(now, wall) && inside <= length_inside(now.outline, edge.a, edge.b) + kRounding);
  });
  return met;
}

/// True if a solid that rises or sinks enters a static block, even if it crosses none of its edges.
bool Motion::meets_inside(const Inputs& in, bodies::SolidRow solid, const PlacedSolid& now,
                          const PlacedSolid& then) const {
  const bodies::Solids& solids = in.solids;
  for (const bodies::SolidRow row : solids.fixed_rows()) {
    if (!solids.full[row] || !solids.is_obstacle(row) || solids.root[row] == solids.root[solid]) continue;
    const PlacedSolid block = solid_now(solids, row);
    if (z_overlaps(then, block) && !z_overlaps(now, block) &&
        distance(then.outline.center, block.outline.center) < solids.radius[solid] + solids.radius[row] &&
        overlap(then.outline, block.outline))
      return true;
  }
  return false;
}

bool Motion::Sweep::add(Conflict conflict) {
  for (std::size_t i = first_conflict; i < conflicts.size(); ++i)
    if (conflicts[i].with == conflict.with) return conflicts[i].if_moved != conflict.if_moved;
  conflicts.push_back(conflict);
  return false;
}

/// True if the outline overlaps a solid of another tree at all of that tree's possible
/// places; if only at some, adds a conflict. Trees that overlap already may separate.
bool Motion::meets_other(const Inputs& in, bodies::SolidRow solid, const PlacedSolid& now,
                         const PlacedSolid& then, bodies::SolidRow other, Sweep& sweep) const {
  const double reach = in.solids.radius[solid] + in.solids.radius[other];
  const auto meets_at = [&](const PlacedSolid& place) {
    const double apart = distance(then.outline.center, place.outline.center);
    if (apart >= reach || !z_overlaps(then, place) || !overlap(then.outline, place.outline)) return false;
    const bool parting = apart >= distance(now.outline.center, place.outline.center) - kRounding;
    return !(parting && z_overlaps(now, place) && overlap(now.outline, place.outline));
  };
  const bool meets_now = meets_at(solid_now(in.solids, other));
  const bodies::TreeRow tree = in.solids.tree[other];
  if (tree > in.solids.tree[solid] || !proposes_[tree]) return meets_now;
  const bool meets_then = meets_at(proposed(in.solids, other));
  if (meets_now == meets_then) return meets_now;
  return sweep.add({tree, meets_then});
}

/// Broad phase: collects solids of other trees near a configuration within its bounding circle.
void Motion::gather(const Inputs& in, bodies::TreeRow tree, const Circle& all, Sweep& sweep) const {
  const world::ModelRow root = trees_->root[tree];
  const double z_low = all.z_min - rise_max_ + bodies::kTouch,
               z_high = all.z_max + rise_max_ - bodies::kTouch;
  const auto collect = [&](const bodies::DiscIndex& index, double reach, bool fast) {
    index.near(all.center, reach, z_low, z_high, [&](const bodies::DiscIndex::Disc& disc) {
      if (disc.root == root || (disc.seen_by & bit(bodies::SeenBy::kMotion)) == 0 ||
          distance(disc.center, all.center) >= disc.radius + reach)
        return;
      const bodies::TreeRow other = in.solids.tree[disc.solid()];
      if (!free_[other] && fast_.is_fast(other) == fast) sweep.near.push_back(&disc);
    });
  };
  sweep.near.clear();
  collect(in.index, all.radius + fast_.reach_of_others(), false);
  if (!fast_.empty()) collect(fast_.index(), all.radius, true);
}

Motion::Circle Motion::circle_about(const bodies::Solids& solids, bodies::TreeRow tree,
                                    const bodies::TreeShape& shape) const {
  const bodies::SolidRows rows = trees_->solids_of(tree);
  Circle all{shape.center[0], 0, 1e300, -1e300};
  for (const bodies::SolidRow row : rows) {
    if (!solids.is_obstacle(row)) continue;
    const HeightRange heights = heights_in(solids, row, shape, rows.front());
    all.radius =
        std::max(all.radius, distance(shape.center[row - rows.front()], all.center) + solids.radius[row]);
    all.z_min = std::min(all.z_min, heights.z_min);
    all.z_max = std::max(all.z_max, heights.z_max);
  }
  return all;
}

bool Motion::meets(const Inputs& in, bodies::TreeRow tree, const bodies::TreeShape& shape,
                   Sweep& sweep) const {
  const bodies::Solids& solids = in.solids;
  const bodies::SolidRows rows = trees_->solids_of(tree);
  if (rows.empty()) return false;
  const bodies::SolidRow first = rows.front();
  const Circle all = circle_about(solids, tree, shape);
  gather(in, tree, all, sweep);
  const bool near_walls = in.walls.clear_about(all.center) <= all.radius;
  for (const bodies::SolidRow row : rows) {
    if (!solids.is_obstacle(row)) continue;
    const geom::Vec2* p = shape.p.data() + (solids.first_vertex[row] - solids.first_vertex[first]);
    const HeightRange heights = heights_in(solids, row, shape, first);
    const PlacedSolid now = solid_now(solids, row),
                      then{outline_at(solids, row, shape.center[row - first], p), heights.z_min,
                           heights.z_max};
    if (!shape.z.empty() && meets_inside(in, row, now, then)) return true;
    if (near_walls && meets_wall(in, row, now, then)) return true;
    const double reach = solids.radius[row] + fast_.reach_of_others();
    // Heights, like places, in the index are those before this tick.
    const HeightRange near{then.z_min - rise_max_, then.z_max + rise_max_};
    for (const bodies::DiscIndex::Disc* const disc : sweep.near)
      if (distance(disc->center, then.outline.center) < disc->radius + reach && z_overlaps(near, *disc) &&
          meets_other(in, row, now, then, disc->solid(), sweep))
        return true;
  }
  return false;
}

/// True if the way is blocked whatever earlier trees do; otherwise its conflicts are in `sweep`.
bool Motion::is_blocked(const Inputs& in, bodies::TreeRow tree, Sweep& sweep) {
  const unsigned steps = steps_of(in, tree);
  const bodies::TreeShape last = proposal(in.solids, tree, sweep);
  const bodies::TreeShape between{{sweep.moved.data(), last.moved.size()},
                                  last.X_WM,
                                  last.rotation,
                                  {sweep.center.data(), last.center.size()},
                                  {sweep.p.data(), last.p.size()},
                                  {sweep.z.data(), last.z.size()}};
  for (unsigned step = 1; step < steps; ++step) {
    shape_at(in, tree, static_cast<double>(step) / steps, between);
    if (meets(in, tree, between, sweep)) return true;
  }
  return meets(in, tree, last, sweep);
}

void Motion::follow(const Inputs& in, bodies::TreeRow tree, std::uint32_t worker) {
  Sweep& sweep = sweeps_[worker];
  sweep.first_conflict = sweep.conflicts.size();
  stalls_[tree] = is_blocked(in, tree, sweep);
  if (stalls_[tree]) sweep.conflicts.resize(sweep.first_conflict);
  conflicts_[tree] = {worker, static_cast<std::uint32_t>(sweep.first_conflict),
                      static_cast<std::uint32_t>(sweep.conflicts.size())};
}

/// Resolves conflicts in row order, so that the outcome for earlier trees is known.
void Motion::decide() {
  for (const bodies::TreeRow tree : trees_->rows()) {
    if (!proposes_[tree]) continue;
    const Conflicts& at = conflicts_[tree];
    for (std::uint32_t i = at.begin; i < at.end; ++i) {
      const Conflict& conflict = sweeps_[at.worker].conflicts[i];
      const bool moved = !stalls_[conflict.with];
      if (moved == conflict.if_moved) stalls_[tree] = 1;
    }
  }
}

/// Recomputes the poses of the tree's models instead of storing them: saves most of the proposal's memory.
void Motion::put(world::Models& models, bodies::Solids& solids, bodies::TreeRow tree) const {
  for (const bodies::Mover& mover : trees_->movers_of(tree))
    models.X_PM.own(mover.model) = moved_[trees_->row_of(mover)];
  for (const world::ModelRow model : trees_->models_of(tree)) {
    const geom::Pose& X_PM = models.X_PM[model];
    if (model == trees_->root[tree]) {
      models.X_WM[model] = X_PM;
      solids.rotation[model] = rotation_[tree];
      continue;
    }
    const world::ModelRow parent = models.parent[model];
    models.X_WM[model] = part_at(models.X_WM[parent], solids.rotation[parent], X_PM);
    solids.rotation[model] = X_PM.a == 0 ? solids.rotation[parent] : geom::Rotation::of(models.X_WM[model].a);
  }
}

void Motion::commit(world::World& world, bodies::Solids& solids, bodies::TreeRow tree) const {
  for (const bodies::Mover& mover : trees_->movers_of(tree)) {
    const bool stalls = stalls_[tree] && is_moving(world, mover);
    bodies::with_move(mover.kind, [&](auto move) { move.stall(world, mover.part, stalls); });
  }
  if (!proposes_[tree] || stalls_[tree]) return;
  put(world.models, solids, tree);
  place(solids, world.models, trees_->solids_of(tree));
  for (const bodies::Mover& mover : trees_->movers_of(tree))
    bodies::with_move(mover.kind, [&](auto move) { move.arrive(world, mover.part); });
}

bool Motion::move(world::World& world, bodies::Solids& solids, const bodies::DiscIndex& index,
                  const bodies::Walls& walls, world::Workers& workers) {
  constexpr std::size_t kGrain = 64;
  const Inputs in{world, solids, index, walls};
  const auto each_tree = [&](const auto& body) {
    workers.run(trees_->size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (const bodies::TreeRow tree : trees_->rows().part(begin, end)) body(tree);
    });
  };
  each_tree([&](bodies::TreeRow tree) { propose(in, tree, sweeps_[workers.current()]); });
  rise_max_ = 0;
  for (const bodies::TreeRow tree : trees_->rows()) {
    if (!lifts_[tree]) continue;
    for (const bodies::SolidRow row : trees_->solids_of(tree))
      rise_max_ = std::max(rise_max_, rise_of(solids, row));
  }
  fast_.find(*trees_, solids, reach_, workers);
  headroom_.begin(fast_.reach_of_others());
  each_tree([&](bodies::TreeRow tree) {
    if (!fast_.empty()) headroom_.avoid(tree, world.models.X_WM[trees_->root[tree]].xy(), fast_);
    if (proposes_[tree]) propose_rest(in, tree, sweeps_[workers.current()]);
  });
  for (Sweep& sweep : sweeps_) sweep.conflicts.clear();
  each_tree([&](bodies::TreeRow tree) {
    conflicts_[tree] = {};
    if (proposes_[tree] && !free_[tree]) follow(in, tree, workers.current());
  });
  decide();
  each_tree([&](bodies::TreeRow tree) { commit(world, solids, tree); });
  for (const bodies::TreeRow tree : trees_->rows())
    if (proposes_[tree] && !stalls_[tree]) return true;
  return false;
}

}  // namespace playhouse::stage
