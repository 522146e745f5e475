#include "playhouse/senses/sense_ranger.h"

#include <algorithm>
#include <cmath>

#include "playhouse/bodies/ray_edge.h"
#include "playhouse/senses/ranger_noise.h"

namespace playhouse::senses {
namespace {

/// Intensities of the beams, by the solids that they hit.
PLAYHOUSE_INLINE void report(const float* returns, const double* solid, std::size_t beams,
                             float* intensities) {
  std::size_t k = 0;
  for (; k + simd::kFour <= beams; k += simd::kFour) {
    simd::Double4 four;
    simd::load(four, solid + k);
    const simd::Int4 row = __builtin_convertvector(four - bodies::kNoSolid, simd::Int4);
    for (std::size_t i = 0; i < simd::kFour; ++i)
      intensities[k + i] = returns[static_cast<std::uint32_t>(row[i])];
  }
  for (; k < beams; ++k) intensities[k] = returns[static_cast<std::uint32_t>(solid[k] - bodies::kNoSolid)];
}

}  // namespace

RangerSense::RangerSense(unsigned workers) : scratch_(workers) {}

SensorTable RangerSense::table(world::World& world) const {
  return {world.rangers.model, world.rangers.measured_tick};
}

void RangerSense::populate(const world::World& world, const bodies::Space& space) {
  const bodies::Solids& solids = space.solids;
  kinds_.populate(world, space.index.radii());
  returns_.assign(1, 0);
  for (const world::ModelRow model : solids.model)
    returns_.push_back(static_cast<float>(world.desc(model).ranger_return));
  is_wall_.assign(world.models.size(), 0);
  for (const bodies::SolidRow row : solids.fixed_rows()) is_wall_[solids.root[row]] = 1;

  std::size_t beams = 2 * rays::Rays::kMost;
  for (const rays::RangerKind& kind : kinds_.kinds) beams = std::max<std::size_t>(beams, kind.beams);
  scratch_beams_ = beams;
  for (rays::Scratch& scratch : scratch_) scratch.make_room(beams, space);
}

std::uint64_t RangerSense::sense(world::World& world, const bodies::Space& space,
                                 std::span<const world::KindRow> due, std::uint64_t tick,
                                 world::Workers& workers) {
  workers.run(due.size(), 8, [&](std::size_t begin, std::size_t end) {
    rays::Scratch& scratch = scratch_[workers.current()];
    while (begin < end) {
      std::size_t next = begin, batch_beams = 0;
      do batch_beams += beams(due[next++]);
      while (next < end && batch_beams + beams(due[next]) <= scratch_beams_);
      measure_batch(world, space, due.subspan(begin, next - begin), tick, scratch);
      begin = next;
    }
  });
  std::uint64_t rays = 0;
  for (const world::RangerRow ranger : due) rays += beams(ranger);
  return rays;
}

void RangerSense::measure_batch(world::World& world, const bodies::Space& space,
                                std::span<const world::KindRow> rangers, std::uint64_t tick,
                                rays::Scratch& scratch) const {
  scratch.first_beam = 0;
  for (const world::RangerRow ranger : rangers) {
    measure(world, space, ranger, tick, scratch);
    scratch.first_beam += beams(ranger);
  }
  rays::finish_rays(space, scratch);
  scratch.first_beam = 0;
  for (const world::RangerRow ranger : rangers) {
    finish(world, ranger, tick, scratch);
    scratch.first_beam += beams(ranger);
  }
}

void RangerSense::measure(world::World& world, const bodies::Space& space, world::RangerRow ranger,
                          std::uint64_t tick, rays::Scratch& scratch) const {
  const world::ModelRow model = world.rangers.model[ranger];
  const world::ModelRow root = world.models.root[model];
  const rays::RangerView view{world.models.X_WM[model], space.solids.rotation[model], root,
                              is_wall_[root] != 0};
  const rays::RangerKind& kind = kinds_.kinds[kinds_.of_ranger[ranger]];
  std::fill_n(scratch.solid.begin() + scratch.first_beam, kind.beams, bodies::kNoSolid);
  for (const rays::Scan& scan : kind.scans) rays::run_scan(space, view, scan, scratch);
  for (const rays::Bundle& bundle : kind.bundles) rays::run_bundle(space, view, bundle, scratch);
  for (const rays::Jitter& jitter : kind.jitters) {
    const double turn = turn_of(world, model, tick, jitter.sensor, jitter.sample);
    run_jitter(space, view, jitter, jitter.bearing + turn, scratch);
  }
}

/// Applies noise and limits, and writes the public columns.
void RangerSense::finish(world::World& world, world::RangerRow ranger, std::uint64_t tick,
                         rays::Scratch& scratch) const {
  const rays::RangerKind& kind = kinds_.kinds[kinds_.of_ranger[ranger]];
  const world::SensorRow first_sensor = world.rangers.first_sensor[ranger];
  if (kind.beams == 0) return;
  if (kind.noisy) add_range_noise(world, ranger, tick, scratch.range.data() + scratch.first_beam);
  // The beams of a ranger's sensors are consecutive.
  float* const ranges = world.sensors.ranges.from(world.sensors.first_beam[first_sensor]);
  float* const intensities = world.sensors.intensities.from(world.sensors.first_beam[first_sensor]);
  const double *range = scratch.range.data() + scratch.first_beam,
               *solid = scratch.solid.data() + scratch.first_beam, *low = kind.range_min.data(),
               *high = kind.range_max.data();
  for (std::uint32_t k = 0; k < kind.beams; ++k) {
    const double above = range[k] > low[k] ? range[k] : low[k];
    ranges[k] = static_cast<float>(above > high[k] ? high[k] : above);
  }
  simd::in_vectors<report>(returns_.data(), solid, kind.beams, intensities);
}

void RangerSense::run_jitter(const bodies::Space& space, const rays::RangerView& view,
                             const rays::Jitter& jitter, double bearing, rays::Scratch& scratch) {
  const geom::Pose X_WS = geom::compose(view.X_WM, jitter.X_MS);
  const geom::Rotation ahead = geom::Rotation::of(X_WS.a + bearing);
  const double z = view.X_WM.z + jitter.z;
  const bodies::Hit hit =
      cast(space, {X_WS.xy(), {ahead.c, ahead.s}, z, z, jitter.range_max, rays::RangerView::kBy, view.root});
  scratch.range[scratch.first_beam + jitter.beam] = hit.range;
  scratch.solid[scratch.first_beam + jitter.beam] =
      hit.solid ? bodies::number_of(hit.solid) : bodies::kNoSolid;
}

std::unique_ptr<SensePhase> make_ranger_sense(unsigned workers) {
  return std::make_unique<RangerSense>(workers);
}

}  // namespace playhouse::senses
