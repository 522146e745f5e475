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

struct Heights {
  double z_min, z_max;  // m
};

template <typename A, typename B>
bool z_overlaps(const A& a, const B& b) {
  return a.z_min < b.z_max - kTouch && b.z_min < a.z_max - kTouch;
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

Motion::Body Motion::body_now(const Solids& solids, std::size_t row) {
  return {outline_now(solids, row), solids.z_min[row], solids.z_max[row]};
}

Motion::Body Motion::proposed(const Solids& solids, std::size_t row) const {
  Body body = body_now(solids, row);
  body.outline = outline_at(solids, row, center_[place_of(row)], p_.data() + vertex_of(solids, row));
  if (!lifts_[solids.tree[row]]) return body;
  const double z = z_[place_of(row)];
  return {body.outline, z + solids.z_min_M[row], z + solids.z_max_M[row]};
}

void Motion::populate(const Trees& trees, const Solids& solids, const world::Models& models) {
  trees_ = &trees;
  fixed_ = solids.fixed;
  fixed_vertices_ = solids.first_vertex[fixed_];
  proposes_.assign(trees.size(), 0);
  stalls_.assign(trees.size(), 0);
  lifts_.assign(trees.size(), 0);
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
    sweep.z.resize(most_solids);
    sweep.p.resize(most_vertices);
    sweep.conflicts.clear();
    sweep.conflicts.reserve(8 * trees.size());  // what few workers meet is met by one
  }
  moved_.resize(trees.movers.size());
  rotation_.resize(trees.size());
  center_.resize(solids.moving());
  z_.resize(solids.moving());
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
          {p_.data() + vertex_of(solids, solid), solids.first_vertex[last] - solids.first_vertex[solid]},
          {z_.data() + place_of(solid), lifts_[tree] ? last - solid : 0}};
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
    if (!out.z.empty()) out.z[row - first_solid] = out.X_WM[local].z;
    for (std::uint32_t v = solids.first_vertex[row]; v < solids.first_vertex[row + 1]; ++v)
      out.p[vertex++] = p + rotation * solids.p_M[v];
  }
}

void Motion::propose(const Surroundings& in, std::uint32_t tree, Sweep& sweep) {
  proposes_[tree] = stalls_[tree] = lifts_[tree] = 0;
  reach_[tree] = 0;
  for (const Mover& mover : movers_of(tree)) {
    if (!is_moving(in.world, mover)) continue;
    proposes_[tree] = 1;
    if (with_move(mover.kind, [&](auto move) { return move.changes_height(in.world, mover.part); }))
      lifts_[tree] = 1;
  }
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
  const double dt = in.world.scene().interval;
  double turn = 0;
  for (const Mover& mover : movers_of(tree))
    turn += with_move(mover.kind, [&](auto move) { return move.turn_rate(in.world, mover.part); }) * dt;
  // What a joint swings round in a tick may come near to where it was.
  const auto swing = [&](Vec2 center) {
    double way = 0;
    for (const Mover& mover : movers_of(tree))
      way += with_move(mover.kind, [&](auto move) { return move.swing(in.world, mover.part, center); }) * dt;
    return way;
  };
  double steps = 1;
  for (std::uint32_t row = trees_->first_solid[tree]; row < trees_->first_solid[tree + 1]; ++row) {
    if (!in.solids.is_obstacle(row)) continue;
    const double way = distance(center_[place_of(row)], in.solids.center[row]) +
                       turn * in.solids.radius[row] + swing(in.solids.center[row]);
    steps = std::max(steps, way / std::max(0.5 * in.solids.width[row], kTouch));
    if (!lifts_[tree]) continue;
    const double height = in.solids.z_max[row] - in.solids.z_min[row];
    steps = std::max(steps, rise_of(in.solids, row) / std::max(0.5 * height, kTouch));
  }
  return static_cast<unsigned>(std::ceil(std::min(steps, static_cast<double>(limits::kMotionSteps))));
}

/// True if the outline reaches deeper into a wall than it did.
bool Motion::meets_wall(const Surroundings& in, std::size_t solid, const Body& now, const Body& then) const {
  const double radius = in.solids.radius[solid];
  const Vec2 center = then.outline.center;
  if (in.walls.clear_about(center) > radius) return false;
  const geom::Box box = box_about(center, radius);
  bool met = false;
  in.walls.near(box, [&](const Walls::Edge& edge) {
    if (met || !in.solids.is_obstacle(edge.solid) || !edge.reaches(box)) return;
    const Heights wall{in.solids.z_min[edge.solid], in.solids.z_max[edge.solid]};
    if (!z_overlaps(then, wall) || in.solids.root[edge.solid] == in.solids.root[solid]) return;
    const double inside = length_inside(then.outline, edge.a, edge.b);
    met = inside > kRounding &&
          !(z_overlaps(now, wall) && inside <= length_inside(now.outline, edge.a, edge.b) + kRounding);
  });
  return met;
}

/// True if a solid that rises or sinks comes into a block that stands still, whose outline may be far.
bool Motion::meets_inside(const Surroundings& in, std::size_t solid, const Body& now,
                          const Body& then) const {
  const Solids& solids = in.solids;
  for (std::size_t row = 0; row < fixed_; ++row) {
    if (!solids.full[row] || !solids.is_obstacle(row) || solids.root[row] == solids.root[solid]) continue;
    const Body block = body_now(solids, row);
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

/// True if the outline overlaps another tree's solid wherever that may come to be. Where it depends on
/// whether that tree moves, that is a conflict. Two that overlap already may part.
bool Motion::meets_other(const Surroundings& in, std::size_t solid, const Body& now, const Body& then,
                         std::size_t other, Sweep& sweep) const {
  const double reach = in.solids.radius[solid] + in.solids.radius[other];
  const auto meets_at = [&](const Body& place) {
    const double apart = distance(then.outline.center, place.outline.center);
    if (apart >= reach || !z_overlaps(then, place) || !overlap(then.outline, place.outline)) return false;
    const bool parting = apart >= distance(now.outline.center, place.outline.center) - kRounding;
    return !(parting && z_overlaps(now, place) && overlap(now.outline, place.outline));
  };
  const bool meets_now = meets_at(body_now(in.solids, other));
  const std::uint32_t tree = in.solids.tree[other];
  if (tree > in.solids.tree[solid] || !proposes_[tree]) return meets_now;
  const bool meets_then = meets_at(proposed(in.solids, other));
  if (meets_now == meets_then) return meets_now;
  return sweep.add({tree, meets_then});
}

bool Motion::meets(const Surroundings& in, std::uint32_t tree, const TreeShape& shape, Sweep& sweep) const {
  const Solids& solids = in.solids;
  const std::uint32_t first = trees_->first_solid[tree], end = trees_->first_solid[tree + 1];
  for (std::uint32_t row = first; row < end; ++row) {
    if (!solids.is_obstacle(row)) continue;
    const Vec2* p = shape.p.data() + (solids.first_vertex[row] - solids.first_vertex[first]);
    const Body now = body_now(solids, row);
    Body then{outline_at(solids, row, shape.center[row - first], p), now.z_min, now.z_max};
    if (!shape.z.empty()) {
      then.z_min = shape.z[row - first] + solids.z_min_M[row];
      then.z_max = shape.z[row - first] + solids.z_max_M[row];
      if (meets_inside(in, row, now, then)) return true;
    }
    if (meets_wall(in, row, now, then)) return true;
    bool met = false;
    const double reach = solids.radius[row] + reach_max_;
    // Heights, like places, are those before this tick.
    const Body near{then.outline, then.z_min - rise_max_, then.z_max + rise_max_};
    in.index.near(then.outline.center, reach, near.z_min + kTouch, near.z_max - kTouch,
                  [&](const DiscIndex::Disc& disc) {
                    if (met || disc.root == solids.root[row] || !solids.is_obstacle(disc.row)) return;
                    if (distance(disc.center, near.outline.center) >= disc.radius + reach) return;
                    if (z_overlaps(near, disc)) met = meets_other(in, row, now, then, disc.row, sweep);
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
                          {sweep.p.data(), last.p.size()},
                          {sweep.z.data(), last.z.size()}};
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
  for (std::uint32_t row = first; lifts_[tree] && row < end; ++row) {
    solids.z_min[row] = z_[place_of(row)] + solids.z_min_M[row];
    solids.z_max[row] = z_[place_of(row)] + solids.z_max_M[row];
  }
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
  reach_max_ = rise_max_ = 0;
  for (std::uint32_t tree = 0; tree < trees_->size(); ++tree) {
    reach_max_ = std::max(reach_max_, reach_[tree]);
    if (!lifts_[tree]) continue;
    for (std::uint32_t row = trees_->first_solid[tree]; row < trees_->first_solid[tree + 1]; ++row)
      rise_max_ = std::max(rise_max_, rise_of(solids, row));
  }
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
