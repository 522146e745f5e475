#include "playhouse/stage/headroom.h"

#include <algorithm>
#include <cmath>

#include "playhouse/bodies/overlap.h"
#include "playhouse/bodies/space.h"

namespace playhouse::stage {
namespace {

constexpr double kFar = 1e300;  // m

double length(geom::Vec2 v) {
  return std::sqrt(geom::dot(v, v));
}

bool moves_as_a_whole(const bodies::Trees& trees, bodies::TreeRow tree) {
  const std::span<const bodies::Mover> movers = trees.movers_of(tree);
  return movers.size() == 1 && movers[0].model == trees.root[tree];
}

}  // namespace

void Headroom::populate(const bodies::Trees& trees, const bodies::Solids& solids,
                        const world::Models& models) {
  rigid_.resize(trees.size());
  arm_.resize(trees.size());
  radius_.resize(trees.size());
  root_ = trees.root;
  walls_block_ = false;
  for (const bodies::SolidRow row : solids.fixed_rows()) walls_block_ |= solids.is_obstacle(row);
  for (const bodies::TreeRow tree : trees.rows()) measure_shape(trees, tree, solids, models);
  drift_ = 0;
  until_.assign(trees.size(), 0);
}

void Headroom::replaced(const bodies::Trees& trees, bodies::TreeRow tree, const bodies::Solids& solids,
                        const world::Models& models) {
  measure_shape(trees, tree, solids, models);
  std::ranges::fill(until_, drift_);
}

void Headroom::measure_shape(const bodies::Trees& trees, bodies::TreeRow tree, const bodies::Solids& solids,
                             const world::Models& models) {
  const geom::Vec2 p = models.X_WM[trees.root[tree]].xy();
  rigid_[tree] = moves_as_a_whole(trees, tree);
  arm_[tree] = radius_[tree] = 0;
  for (const bodies::SolidRow row : trees.solids_of(tree)) {
    const double arm = length(solids.center[row] - p);
    arm_[tree] = std::max(arm_[tree], arm + bodies::kMargin);
    if (solids.is_obstacle(row))
      radius_[tree] = std::max(radius_[tree], arm + solids.radius[row] + bodies::kMargin);
  }
}

void Headroom::begin(double others) {
  others_ = others + bodies::kMargin;
  drift_ += others_;
}

void Headroom::avoid(bodies::TreeRow tree, geom::Vec2 p, const bodies::FastBodies& fast) {
  const double before = until_[tree] - drift_;
  if (before <= 0 || fast.empty()) return;
  double room = before;
  fast.index().near(p, radius_[tree] + room, -kFar, kFar, [&](const bodies::DiscIndex::Disc& disc) {
    if (disc.root == root_[tree] || (disc.seen_by & bit(bodies::SeenBy::kMotion)) == 0) return;
    room = std::min(room, length(disc.center - p) - disc.radius - radius_[tree] - bodies::kMargin);
  });
  if (room < before) until_[tree] = drift_ + room;
}

void Headroom::measure(bodies::TreeRow tree, geom::Vec2 p, double way, const bodies::Solids& solids,
                       const bodies::DiscIndex& index, const bodies::Walls& walls) {
  constexpr double kTicks = 12;  // search radius, in ticks of motion: how long a query may last
  const double radius = radius_[tree];
  double room = kTicks * (way + others_);
  index.near(p, radius + room, -kFar, kFar, [&](const bodies::DiscIndex::Disc& disc) {
    if (disc.root == root_[tree] || (disc.seen_by & bit(bodies::SeenBy::kMotion)) == 0) return;
    room = std::min(room, length(disc.center - p) - disc.radius - radius);
  });
  if (walls_block_ && walls.clear_about(p) < radius + room) {
    const geom::Box box = bodies::box_about(p, radius + std::max(room, 0.0));
    walls.near(box, [&](const bodies::Walls::Edge& edge) {
      if (!edge.reaches(box) || !solids.is_obstacle(edge.solid)) return;
      room = std::min(room, bodies::distance_to_segment(p, edge.a, edge.b) - radius);
    });
  }
  until_[tree] = drift_ - others_ + room - bodies::kMargin;
}

}  // namespace playhouse::stage
