#include "playhouse/senses/sense_fiducial.h"

#include <algorithm>
#include <cmath>

namespace playhouse::senses {
namespace {

/// True if nothing of another tree blocks the line of sight from the finder to the target's centre.
bool in_sight(const bodies::Space& space, geom::Vec2 from, double z, geom::Vec2 to, double distance,
              world::ModelRow own, world::ModelRow target) {
  if (distance <= 0) return true;
  const geom::Vec2 d = (1.0 / distance) * (to - from);
  const bodies::Hit hit = cast(space, {from, d, z, z, distance, bit(bodies::SeenBy::kFiducial), own, target});
  return !hit.solid;
}

}  // namespace

SensorTable FiducialSense::table(world::World& world) const {
  return {world.fiducials.model, world.fiducials.measured_tick};
}

void FiducialSense::populate(const world::World& world, const bodies::Space&) {
  const std::size_t models = world.fiducials.size() > 0 ? world.models.size() : 0;
  z_min_.resize(models);
  z_max_.resize(models);
  marked_.reserve(models);
  targets_.populate(models, 0.25);
}

/// Of the bodies as they are now: parts of a robot may have risen. With a margin for the
/// rounding of heights in W: a finder on top of a body is at its upper end, wherever the two are.
void FiducialSense::measure_heights(const bodies::Solids& solids) {
  std::ranges::fill(z_min_, 1e300);
  std::ranges::fill(z_max_, -1e300);
  for (const bodies::SolidRow row : solids.rows()) {
    const world::ModelRow top = solids.root[row];
    z_min_[top] = std::min(z_min_[top], solids.z_min[row] - bodies::kMargin);
    z_max_[top] = std::max(z_max_[top], solids.z_max[row] + bodies::kMargin);
  }
}

std::uint64_t FiducialSense::sense(world::World& world, const bodies::Space& space,
                                   std::span<const world::KindRow> due, std::uint64_t,
                                   world::Workers& workers) {
  measure_heights(space.solids);
  marked_.clear();
  for (const world::ModelRow row : world.models.rows())
    if (world.models.fiducial_return[row] != 0) marked_.push_back(row);
  targets_.rebuild(
      marked_.size(),
      [&](std::size_t i) {
        const world::ModelRow row = marked_[i];
        return bodies::DiscIndex::Disc{world.models.X_WM[row].xy(), 0, 0, 0, row.index,
                                       world.models.root[row]};
      },
      workers);
  workers.run(due.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) find(world, space, due[i]);
  });
  std::uint64_t rays = 0;
  for (const world::FiducialRow finder : due) rays += world.fiducials.hits[finder].size();
  return rays;
}

void FiducialSense::find(world::World& world, const bodies::Space& space, world::FiducialRow finder) const {
  const world::ModelRow model = world.fiducials.model[finder];
  const scene::ModelDesc& desc = world.desc(model);
  const scene::FiducialDesc& limits = *desc.fiducial;
  const geom::Pose X_WB = geom::compose(world.models.X_WM[model], desc.X_MB);
  const world::ModelRow own = world.models.root[model];
  std::vector<world::FiducialHit>& hits = world.fiducials.hits[finder];
  hits.clear();
  targets_.near(X_WB.xy(), limits.range_max, 0, 0, [&](const bodies::DiscIndex::Disc& disc) {
    const geom::Vec2 p_W = disc.center - X_WB.xy();
    const double squared = geom::dot(p_W, p_W);
    if (disc.root == own || squared >= limits.range_max * limits.range_max) return;
    if (squared < limits.range_min * limits.range_min) return;
    const world::ModelRow target = disc.model();
    if (world.desc(target).fiducial_key != desc.fiducial_key) return;
    const double bearing = geom::normalize(geom::atan2(p_W.y, p_W.x) - X_WB.a);
    if (std::fabs(bearing) > 0.5 * limits.fov) return;
    const bool has_body = z_min_[disc.root] <= z_max_[disc.root];
    if (!limits.ignore_zloc && has_body && (X_WB.z < z_min_[disc.root] || X_WB.z > z_max_[disc.root])) return;
    const double range = std::sqrt(squared);
    if (!in_sight(space, X_WB.xy(), X_WB.z, disc.center, range, own, disc.root)) return;
    const geom::Pose& X_WT = world.models.X_WM[target];
    hits.push_back({world.id(target), range < limits.range_max_id ? world.models.fiducial_return[target] : 0,
                    range, bearing, geom::normalize(X_WT.a - X_WB.a), world.desc(target).size});
  });
  std::sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.target < b.target; });
}

std::unique_ptr<SensePhase> make_fiducial_sense(unsigned) {
  return std::make_unique<FiducialSense>();
}

}  // namespace playhouse::senses
