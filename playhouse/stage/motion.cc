#include "playhouse/stage/motion.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "playhouse/base/limits.h"
#include "playhouse/stage/generated/moves.h"

namespace playhouse::stage {
namespace {

constexpr double kRounding = 1e-9;  // m; deeper by less than this is not deeper

bool is_moving(const world::World& world, const Mover& mover) {
  return with_move(mover.kind, [&](auto move) { return move.is_moving(world, mover.part); });
}

double distance(Vec2 a, Vec2 b) {
  return std::sqrt(geom::dot(b - a, b - a));
}

bool z_overlaps(const Solids& solids, std::size_t a, std::size_t b) {
  return solids.z_min[a] < solids.z_max[b] - kTouch && solids.z_min[b] < solids.z_max[a] - kTouch;
}

Pose part_at(const Pose& X_WP, Rotation rotation, const Pose& X_PM) {
  const Vec2 p = X_WP.xy() + rotation * X_PM.xy();
  return {p.x, p.y, X_WP.z + X_PM.z, geom::normalize(X_WP.a + X_PM.a)};
}

Outline outline_at(const Solids& solids, std::size_t row, Vec2 center, const Vec2* p) {
  const std::size_t vertices = solids.first_vertex[row + 1] - solids.first_vertex[row] - 1;
  return {{p, vertices}, center, solids.convex[row] != 0};
}

Outline outline_now(const Solids& solids, std::size_t row) {
  return outline_at(solids, row, solids.center[row], solids.p.data() + solids.first_vertex[row]);
}

}  // namespace

void Motion::populate(const Trees& trees, const Solids& solids, const world::Models& models) {
  trees_ = &trees;
  fixed_ = solids.fixed;
  fixed_vertices_ = solids.first_vertex[fixed_];
  proposes_.assign(trees.size(), 0);
  stalls_.assign(trees.size(), 0);
  conflicts_.assign(trees.size(), {});
  reach_.assign(trees.size(), 0);
  first_parent_.assign(trees.size(), world::ModelRow::kNone);
  parent_.clear();
  std::size_t largest_tree = 0, most_solids = 0, most_vertices = 0;
  for (std::size_t tree = 0; tree < trees.size(); ++tree) {
    const std::uint32_t begin = trees.first_model[tree], end = trees.first_model[tree + 1];
    add_parents(std::span(trees.models).subspan(begin, end - begin), models,
                static_cast<std::uint32_t>(tree));
    const std::uint32_t first = trees.first_solid[tree], last = trees.first_solid[tree + 1];
    largest_tree = std::max<std::size_t>(largest_tree, end - begin);
    most_solids = std::max<std::size_t>(most_solids, last - first);
    most_vertices =
        std::max<std::size_t>(most_vertices, solids.first_vertex[last] - solids.first_vertex[first]);
  }
  for (Sweep& sweep : sweeps_) {
    sweep.moved.resize(largest_tree);
    sweep.X_WM.resize(largest_tree);
    sweep.rotation.resize(largest_tree);
    sweep.center.resize(most_solids);
    sweep.p.resize(most_vertices);
    sweep.conflicts.clear();
    sweep.conflicts.reserve(8 * trees.size());  // what few workers meet is met by one
  }
  moved_.resize(trees.movers.size());
  rotation_.resize(trees.size());
  center_.resize(solids.moving());
  p_.resize(solids.p_M.size() - fixed_vertices_);
}

void Motion::add_parents(std::span<const std::uint32_t> rows, const world::Models& models,
                         std::uint32_t tree) {
  bool is_run = true;
  for (std::size_t i = 0; i < rows.size(); ++i) is_run = is_run && rows[i] == rows[0] + i;
  if (is_run) return;
  first_parent_[tree] = static_cast<std::uint32_t>(parent_.size());
  std::map<std::uint32_t, std::uint32_t> place;  // of a model in its tree
  for (const std::uint32_t row : rows) {
    parent_.push_back(place.empty() ? 0 : place.at(models.parent[row]));
    place.emplace(row, static_cast<std::uint32_t>(place.size()));
  }
}

TreeShape Motion::proposal(const Solids& solids, std::uint32_t tree, Sweep& sweep) {
  const std::uint32_t models = trees_->first_model[tree + 1] - trees_->first_model[tree];
  const std::uint32_t solid = trees_->first_solid[tree], last = trees_->first_solid[tree + 1];
  return {{moved_.data() + trees_->first_mover[tree], movers_of(tree).size()},
          {sweep.X_WM.data(), models},
          {sweep.rotation.data(), models},
          {center_.data() + place_of(solid), last - solid},
          {p_.data() + vertex_of(solids, solid), solids.first_vertex[last] - solids.first_vertex[solid]}};
}

/// The tree after `fraction` of this tick's motion.
void Motion::shape_at(const Surroundings& in, std::uint32_t tree, double fraction,
                      const TreeShape& out) const {
  const world::Models& models = in.world.models;
  const double dt = in.world.scene().interval * fraction;
  const std::uint32_t first = trees_->first_model[tree];
  const std::span<const Mover> movers = movers_of(tree);
  std::size_t next = 0;  // of movers
  for (std::size_t i = 0; i < out.X_WM.size(); ++i) {
    const std::uint32_t model = trees_->models[first + i];
    const Pose* X_PM = &models.X_PM[model];
    if (next < movers.size() && movers[next].model == model) {
      const Mover& mover = movers[next];
      Pose& X = out.moved[next++];
      X = with_move(mover.kind, [&](auto move) { return move.after(in.world, mover.part, *X_PM, dt); });
      X_PM = &X;
    }
    if (i == 0) {
      out.X_WM[0] = *X_PM;
      out.rotation[0] = Rotation::of(out.X_WM[0].a);
      continue;
    }
    const std::uint32_t parent = parent_of(models, tree, model, i);
    out.X_WM[i] = part_at(out.X_WM[parent], out.rotation[parent], *X_PM);
    out.rotation[i] = X_PM->a == 0 ? out.rotation[parent] : Rotation::of(out.X_WM[i].a);
  }

  const Solids& solids = in.solids;
  const std::uint32_t first_solid = trees_->first_solid[tree], end = trees_->first_solid[tree + 1];
  std::size_t local = 0, vertex = 0;
  for (std::uint32_t row = first_solid; row < end; ++row) {
    while (trees_->models[first + local] != solids.model[row]) ++local;
    const Vec2 p = out.X_WM[local].xy();
    const Rotation rotation = out.rotation[local];
    out.center[row - first_solid] = p + rotation * solids.center_M[row];
    for (std::uint32_t v = solids.first_vertex[row]; v < solids.first_vertex[row + 1]; ++v)
      out.p[vertex++] = p + rotation * solids.p_M[v];
  }
}

void Motion::propose(const Surroundings& in, std::uint32_t tree, Sweep& sweep) {
  proposes_[tree] = stalls_[tree] = 0;
  reach_[tree] = 0;
  for (const Mover& mover : movers_of(tree))
    if (is_moving(in.world, mover)) proposes_[tree] = 1;
  if (!proposes_[tree]) return;
  const TreeShape shape = proposal(in.solids, tree, sweep);
  shape_at(in, tree, 1.0, shape);
  rotation_[tree] = shape.rotation[0];
  for (std::size_t i = 0; i < shape.center.size(); ++i)
    reach_[tree] =
        std::max(reach_[tree], distance(shape.center[i], in.solids.center[trees_->first_solid[tree] + i]));
}

/// Steps so short that nothing is jumped: each moves no solid by more than half its width.
unsigned Motion::steps_of(const Surroundings& in, std::uint32_t tree) const {
  double turn = 0;
  for (const Mover& mover : movers_of(tree))
    turn += with_move(mover.kind, [&](auto move) { return move.turn_rate(in.world, mover.part); }) *
            in.world.scene().interval;
  double steps = 1;
  for (std::uint32_t row = trees_->first_solid[tree]; row < trees_->first_solid[tree + 1]; ++row) {
    if (!in.solids.is_obstacle(row)) continue;
    const double way = distance(center_[place_of(row)], in.solids.center[row]) + turn * in.solids.radius[row];
    steps = std::max(steps, way / std::max(0.5 * in.solids.width[row], kTouch));
  }
  return static_cast<unsigned>(std::ceil(std::min(steps, static_cast<double>(limits::kMotionSteps))));
}

/// True if the outline reaches deeper into a wall than it did.
bool Motion::meets_wall(const Surroundings& in, std::size_t solid, const Outline& now,
                        const Outline& then) const {
  const double radius = in.solids.radius[solid];
  if (in.walls.clear_about(then.center) > radius) return false;
  const geom::Box box = box_about(then.center, radius);
  bool met = false;
  in.walls.near(box, [&](const Walls::Edge& edge) {
    if (met || !in.solids.is_obstacle(edge.solid) || !z_overlaps(in.solids, solid, edge.solid)) return;
    if (!edge.reaches(box) || in.solids.root[edge.solid] == in.solids.root[solid]) return;
    const double inside = length_inside(then, edge.a, edge.b);
    met = inside > kRounding && inside > length_inside(now, edge.a, edge.b) + kRounding;
  });
  return met;
}

bool Motion::Sweep::add(Conflict conflict) {
  for (std::size_t i = first_conflict; i < conflicts.size(); ++i)
    if (conflicts[i].with == conflict.with) return conflicts[i].if_moved != conflict.if_moved;
  conflicts.push_back(conflict);
  return false;
}

/// True if the outline overlaps another tree's solid wherever that may come to be. Where it depends on
/// whether that tree moves, that is a conflict. Two that overlap already may part.
bool Motion::meets_other(const Surroundings& in, std::size_t solid, const Outline& now, const Outline& then,
                         std::size_t other, Sweep& sweep) const {
  const double reach = in.solids.radius[solid] + in.solids.radius[other];
  const auto meets_at = [&](const Outline& place) {
    const double apart = distance(then.center, place.center);
    if (apart >= reach || !overlap(then, place)) return false;
    const bool parting = apart >= distance(now.center, place.center) - kRounding;
    return !(parting && overlap(now, place));
  };
  const bool meets_now = meets_at(outline_now(in.solids, other));
  const std::uint32_t tree = in.solids.tree[other];
  if (tree > in.solids.tree[solid] || !proposes_[tree]) return meets_now;
  const bool meets_then = meets_at(
      outline_at(in.solids, other, center_[place_of(other)], p_.data() + vertex_of(in.solids, other)));
  if (meets_now == meets_then) return meets_now;
  return sweep.add({tree, meets_then});
}

bool Motion::meets(const Surroundings& in, std::uint32_t tree, const TreeShape& shape, Sweep& sweep) const {
  const Solids& solids = in.solids;
  const std::uint32_t first = trees_->first_solid[tree], end = trees_->first_solid[tree + 1];
  for (std::uint32_t row = first; row < end; ++row) {
    if (!solids.is_obstacle(row)) continue;
    const Vec2* p = shape.p.data() + (solids.first_vertex[row] - solids.first_vertex[first]);
    const Outline now = outline_now(solids, row),
                  then = outline_at(solids, row, shape.center[row - first], p);
    if (meets_wall(in, row, now, then)) return true;
    bool met = false;
    const double reach = solids.radius[row] + reach_max_;
    in.index.near(
        then.center, reach, solids.z_min[row] + kTouch, solids.z_max[row] - kTouch,
        [&](const DiscIndex::Disc& disc) {
          if (met || disc.root == solids.root[row] || !solids.is_obstacle(disc.row)) return;
          if (distance(disc.center, then.center) >= disc.radius + reach || !z_overlaps(solids, row, disc.row))
            return;
          met = meets_other(in, row, now, then, disc.row, sweep);
        });
    if (met) return true;
  }
  return false;
}

/// True if the way of a tree is blocked whatever the trees before it do; else `sweep` has its conflicts.
bool Motion::is_blocked(const Surroundings& in, std::uint32_t tree, Sweep& sweep) {
  const unsigned steps = steps_of(in, tree);
  const TreeShape last = proposal(in.solids, tree, sweep);
  const TreeShape between{{sweep.moved.data(), last.moved.size()},
                          last.X_WM,
                          last.rotation,
                          {sweep.center.data(), last.center.size()},
                          {sweep.p.data(), last.p.size()}};
  for (unsigned step = 1; step < steps; ++step) {
    shape_at(in, tree, static_cast<double>(step) / steps, between);
    if (meets(in, tree, between, sweep)) return true;
  }
  return meets(in, tree, last, sweep);
}

void Motion::follow(const Surroundings& in, std::uint32_t tree, std::uint32_t worker) {
  Sweep& sweep = sweeps_[worker];
  sweep.first_conflict = sweep.conflicts.size();
  stalls_[tree] = is_blocked(in, tree, sweep);
  if (stalls_[tree]) sweep.conflicts.resize(sweep.first_conflict);
  conflicts_[tree] = {worker, static_cast<std::uint32_t>(sweep.first_conflict),
                      static_cast<std::uint32_t>(sweep.conflicts.size())};
}

/// In row order, so that what a tree before this one does is known.
void Motion::decide() {
  for (std::size_t tree = 0; tree < trees_->size(); ++tree) {
    if (!proposes_[tree]) continue;
    const Conflicts& at = conflicts_[tree];
    for (std::uint32_t i = at.begin; i < at.end; ++i) {
      const Conflict& conflict = sweeps_[at.worker].conflicts[i];
      const bool moved = !stalls_[conflict.with];
      if (moved == conflict.if_moved) stalls_[tree] = 1;
    }
  }
}

/// Computes again where the parts of the proposal are: most memory would be theirs otherwise.
void Motion::put(world::Models& models, std::uint32_t tree, Sweep& sweep) const {
  const std::uint32_t first = trees_->first_model[tree];
  for (std::uint32_t i = trees_->first_mover[tree]; i < trees_->first_mover[tree + 1]; ++i)
    models.X_PM.own(trees_->movers[i].model) = moved_[i];
  for (std::uint32_t i = first; i < trees_->first_model[tree + 1]; ++i) {
    const std::uint32_t model = trees_->models[i];
    const Pose& X_PM = models.X_PM[model];
    if (i == first) {
      models.X_WM[model] = X_PM;
      sweep.rotation[0] = rotation_[tree];
      continue;
    }
    const std::uint32_t parent = parent_of(models, tree, model, i - first);
    models.X_WM[model] = part_at(models.X_WM[models.parent[model]], sweep.rotation[parent], X_PM);
    if (models.first_child[model] == world::ModelRow::kNone) continue;
    sweep.rotation[i - first] = X_PM.a == 0 ? sweep.rotation[parent] : Rotation::of(models.X_WM[model].a);
  }
}

void Motion::commit(world::World& world, Solids& solids, std::uint32_t tree, Sweep& sweep) const {
  for (const Mover& mover : movers_of(tree)) {
    const bool stalls = stalls_[tree] && is_moving(world, mover);
    with_move(mover.kind, [&](auto move) { move.stall(world, mover.part, stalls); });
  }
  if (!proposes_[tree] || stalls_[tree]) return;
  put(world.models, tree, sweep);
  const std::uint32_t first = trees_->first_solid[tree], end = trees_->first_solid[tree + 1];
  std::copy_n(center_.begin() + static_cast<std::ptrdiff_t>(place_of(first)), end - first,
              solids.center.begin() + first);
  const std::uint32_t vertex = solids.first_vertex[first], last_vertex = solids.first_vertex[end];
  std::copy_n(p_.begin() + static_cast<std::ptrdiff_t>(vertex_of(solids, first)), last_vertex - vertex,
              solids.p.begin() + vertex);
  for (const Mover& mover : movers_of(tree))
    with_move(mover.kind, [&](auto move) { move.arrive(world, mover.part); });
}

bool Motion::move(world::World& world, Solids& solids, const DiscIndex& index, const Walls& walls,
                  world::Workers& workers) {
  constexpr std::size_t kGrain = 64;
  const Surroundings in{world, solids, index, walls};
  const auto each_tree = [&](const auto& body) {
    workers.run(trees_->size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t tree = begin; tree < end; ++tree) body(static_cast<std::uint32_t>(tree));
    });
  };
  each_tree([&](std::uint32_t tree) { propose(in, tree, sweeps_[workers.current()]); });
  reach_max_ = 0;
  for (const double reach : reach_) reach_max_ = std::max(reach_max_, reach);
  for (Sweep& sweep : sweeps_) sweep.conflicts.clear();
  each_tree([&](std::uint32_t tree) {
    if (proposes_[tree]) follow(in, tree, workers.current());
  });
  decide();
  each_tree([&](std::uint32_t tree) { commit(world, solids, tree, sweeps_[workers.current()]); });
  for (std::size_t tree = 0; tree < trees_->size(); ++tree)
    if (proposes_[tree] && !stalls_[tree]) return true;
  return false;
}

}  // namespace playhouse::stage
