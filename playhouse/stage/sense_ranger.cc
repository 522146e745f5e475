#include "playhouse/stage/sense_ranger.h"

#include <algorithm>
#include <cmath>

#include "playhouse/stage/ranger_noise.h"
#include "playhouse/stage/ray_edge.h"

namespace playhouse::stage {
namespace {

/// Intensities of the beams, by the solids that they hit.
PLAYHOUSE_INLINE void report(const float* returns, const double* solid, std::size_t beams,
                             float* intensities) {
  std::size_t k = 0;
  for (; k + kFour <= beams; k += kFour) {
    Four four;
    load(four, solid + k);
    const FourInts row = __builtin_convertvector(four - kNoSolid, FourInts);
    for (std::size_t i = 0; i < kFour; ++i) intensities[k + i] = returns[static_cast<std::uint32_t>(row[i])];
  }
  for (; k < beams; ++k) intensities[k] = returns[static_cast<std::uint32_t>(solid[k] - kNoSolid)];
}

}  // namespace

RangerSense::RangerSense(unsigned workers) : scratch_(workers) {}

SensorTable RangerSense::table(world::World& world) const {
  return {world.rangers.model, world.rangers.measured_tick};
}

void RangerSense::populate(const world::World& world, const Space& space) {
  const Solids& solids = space.solids;
  kinds_.populate(world, space.index.radii());
  returns_.assign(1, 0);
  for (const std::uint32_t model : solids.model)
    returns_.push_back(static_cast<float>(world.desc({model}).ranger_return));
  is_wall_.assign(world.models.size(), 0);
  for (std::size_t row = 0; row < solids.fixed; ++row) is_wall_[solids.root[row]] = 1;

  std::size_t beams = 2 * Rays::kMost;
  for (const RangerKind& kind : kinds_.kinds) beams = std::max<std::size_t>(beams, kind.beams);
  scratch_beams_ = beams;
  for (Scratch& scratch : scratch_) scratch.make_room(beams, space);
}

void RangerSense::Scratch::make_room(std::size_t beams, const Space& space) {
  const Solids& solids = space.solids;
  for (std::vector<double>* column : {&range, &solid, &beam_x, &beam_y}) column->resize(beams + Scan::kSpare);
  const std::size_t bodies = solids.moving() + kEight;  // padded for vectors of eight
  for (std::vector<double>* column : {&x, &y, &distance, &bearing, &radius}) column->resize(bodies);
  place.resize(bodies);
  order.resize(bodies);
  for (std::vector<std::int32_t>* column : {&ring, &first, &last}) column->resize(bodies);
  met_by.resize(bodies);
  cell.resize(bodies);
  runs.resize(space.index.most_runs());
  stamp.assign(solids.first_vertex[solids.fixed], 0);
  scans = 0;
}

std::uint64_t RangerSense::sense(world::World& world, const Space& space, std::span<const std::uint32_t> due,
                                 std::uint64_t tick, world::Workers& workers) {
  workers.run(due.size(), 8, [&](std::size_t begin, std::size_t end) {
    Scratch& scratch = scratch_[workers.current()];
    while (begin < end) {
      std::size_t next = begin, batch_beams = 0;
      do batch_beams += beams(due[next++]);
      while (next < end && batch_beams + beams(due[next]) <= scratch_beams_);
      measure_batch(world, space, due.subspan(begin, next - begin), tick, scratch);
      begin = next;
    }
  });
  std::uint64_t rays = 0;
  for (const std::uint32_t ranger : due) rays += beams(ranger);
  return rays;
}

void RangerSense::measure_batch(world::World& world, const Space& space,
                                std::span<const std::uint32_t> rangers, std::uint64_t tick,
                                Scratch& scratch) const {
  scratch.first_beam = 0;
  for (const std::uint32_t ranger : rangers) {
    measure(world, space, ranger, tick, scratch);
    scratch.first_beam += beams(ranger);
  }
  finish_rays(space, scratch);
  scratch.first_beam = 0;
  for (const std::uint32_t ranger : rangers) {
    finish(world, ranger, tick, scratch);
    scratch.first_beam += beams(ranger);
  }
}

void RangerSense::measure(world::World& world, const Space& space, std::uint32_t ranger, std::uint64_t tick,
                          Scratch& scratch) const {
  const std::uint32_t model = world.rangers.model[ranger].index;
  const std::uint32_t root = world.models.root[model];
  const View view{world.models.X_WM[model], space.solids.rotation[model], root, is_wall_[root] != 0};
  const RangerKind& kind = kinds_.kinds[kinds_.of_ranger[ranger]];
  std::fill_n(scratch.solid.begin() + scratch.first_beam, kind.beams, kNoSolid);
  for (const Scan& scan : kind.scans) run_scan(space, view, scan, scratch);
  for (const Bundle& bundle : kind.bundles) run_bundle(space, view, bundle, scratch);
  for (const Jitter& jitter : kind.jitters) {
    const double turn = turn_of(world, {model}, tick, jitter.sensor, jitter.sample);
    run_jitter(space, view, jitter, jitter.bearing + turn, scratch);
  }
}

/// Applies noise and limits, and writes the public columns.
void RangerSense::finish(world::World& world, std::uint32_t ranger, std::uint64_t tick,
                         Scratch& scratch) const {
  const RangerKind& kind = kinds_.kinds[kinds_.of_ranger[ranger]];
  const std::uint32_t first_sensor = world.rangers.first_sensor[ranger];
  if (kind.beams == 0) return;
  if (kind.noisy) add_range_noise(world, ranger, tick, scratch.range.data() + scratch.first_beam);
  // The beams of a ranger's sensors are consecutive.
  float* const ranges = world.sensors.ranges.data() + world.sensors.first_beam[first_sensor];
  float* const intensities = world.sensors.intensities.data() + world.sensors.first_beam[first_sensor];
  const double *range = scratch.range.data() + scratch.first_beam,
               *solid = scratch.solid.data() + scratch.first_beam, *low = kind.range_min.data(),
               *high = kind.range_max.data();
  for (std::uint32_t k = 0; k < kind.beams; ++k) {
    const double above = range[k] > low[k] ? range[k] : low[k];
    ranges[k] = static_cast<float>(above > high[k] ? high[k] : above);
  }
  in_vectors<report>(returns_.data(), solid, kind.beams, intensities);
}

void RangerSense::run_jitter(const Space& space, const View& view, const Jitter& jitter, double bearing,
                             Scratch& scratch) {
  const Pose X_WS = geom::compose(view.X_WM, jitter.X_MS);
  const Rotation ahead = Rotation::of(X_WS.a + bearing);
  const double z = view.X_WM.z + jitter.z;
  const Hit hit = cast(space, {X_WS.xy(), {ahead.c, ahead.s}, z, z, jitter.range_max, View::kBy, view.root});
  scratch.range[scratch.first_beam + jitter.beam] = hit.range;
  scratch.solid[scratch.first_beam + jitter.beam] =
      hit.solid == world::ModelRow::kNone ? kNoSolid : number_of(hit.solid);
}

std::unique_ptr<SensePhase> make_ranger_sense(unsigned workers) {
  return std::make_unique<RangerSense>(workers);
}

}  // namespace playhouse::stage
