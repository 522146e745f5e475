#include "playhouse/stage/sense_ranger.h"

#include <algorithm>
#include <cmath>

#include "playhouse/base/rng.h"

namespace playhouse::stage {
namespace {

double noisy(double range, const scene::RangerSensorDesc& sensor, Rng& rng) {
  if (sensor.noise_proportional > 0) range += range * sensor.noise_proportional * rng.uniform(-1, 1);
  if (sensor.noise_constant > 0) range += sensor.noise_constant * rng.gaussian();
  return range;
}

}  // namespace

std::uint64_t ticks_of(double update_interval, double interval) {
  const double ticks = std::ceil(update_interval / interval - 1e-6);
  return ticks < 1 ? 1 : ticks > 1e15 ? std::uint64_t{1000000000000000} : static_cast<std::uint64_t>(ticks);
}

RangerSense::RangerSense(const world::World& world, const Solids& solids, unsigned workers) {
  double body_radius = 0;
  for (std::size_t row = solids.fixed; row < solids.size(); ++row) {
    body_radius = std::max(body_radius, solids.radius[row]);
  }
  kinds_ = make_ranger_kinds(world, body_radius);
  is_wall_.assign(world.models.size(), 0);
  for (std::size_t row = 0; row < solids.fixed; ++row) is_wall_[solids.root[row]] = 1;
  for (const world::ModelRow model : world.rangers.model)
    period_.push_back(ticks_of(world.desc(model).update_interval, world.scene().interval));

  Scratch scratch;
  std::size_t beams = 0;
  for (const RangerKind& kind : kinds_.kinds) beams = std::max<std::size_t>(beams, kind.beams);
  scratch_beams_ = std::max<std::size_t>(beams, 2 * Rays::kMost);
  scratch.range.resize(scratch_beams_ + Scan::kSpare);
  scratch.intensity.resize(scratch_beams_ + Scan::kSpare);
  scratch.x.resize(solids.moving() + 1);
  scratch.y.resize(solids.moving() + 1);
  scratch.distance.resize(solids.moving() + 1);
  scratch.bearing.resize(solids.moving() + 1);
  scratch.place.resize(solids.moving() + 1);
  scratch.order.resize(solids.moving() + 1);
  scratch.ring.resize(solids.moving() + 1);
  scratch.met_by.resize(solids.moving() + 1);
  scratch_.assign(workers, scratch);
  due_.reserve(world.rangers.size());
}

std::uint64_t RangerSense::sense(world::World& world, const Space& space, std::uint64_t tick,
                                 world::Workers& workers) {
  std::uint64_t rays = 0;
  due_.clear();
  for (std::uint32_t ranger = 0; ranger < world.rangers.size(); ++ranger) {
    const std::uint64_t measured = world.rangers.measured_tick[ranger];
    if (world.models.subscribers[world.rangers.model[ranger].index] == 0) continue;
    if (tick - measured < period_[ranger]) continue;
    due_.push_back(ranger);
    rays += beams(ranger);
  }
  for (Scratch& scratch : scratch_) scratch.stamp.resize(space.walls.edge_count(), 0);
  workers.run(due_.size(), 8, [&](std::size_t begin, std::size_t end) {
    Scratch& scratch = scratch_[workers.current()];
    while (begin < end) {
      std::size_t next = begin, batch_beams = 0;
      do batch_beams += beams(due_[next++]);
      while (next < end && batch_beams + beams(due_[next]) <= scratch_beams_);
      measure_batch(world, space, {due_.data() + begin, next - begin}, tick, scratch);
      begin = next;
    }
  });
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
  const View view{world.models.X_WM[model], root, is_wall_[root] != 0};
  const RangerKind& kind = kinds_.kinds[kinds_.of_ranger[ranger]];
  std::fill_n(scratch.intensity.begin() + scratch.first_beam, kind.beams, 0.0);
  for (const Scan& scan : kind.scans) run_scan(space, view, scan, scratch);
  for (const Bundle& bundle : kind.bundles) run_bundle(space, view, bundle, scratch);
  for (const Jitter& jitter : kind.jitters) {
    const std::uint32_t id = world.models.id[model].value;
    Rng rng(world.seed(), tick, {Purpose::kBeamBearing, id, jitter.sensor, jitter.sample});
    run_jitter(space, view, jitter, jitter.bearing + rng.uniform(-jitter.spread, jitter.spread), scratch);
  }
}

/// Noise, limits, and the columns that everyone reads.
void RangerSense::finish(world::World& world, std::uint32_t ranger, std::uint64_t tick,
                         Scratch& scratch) const {
  const RangerKind& kind = kinds_.kinds[kinds_.of_ranger[ranger]];
  const std::uint32_t first_sensor = world.rangers.first_sensor[ranger];
  const world::ModelRow model = world.rangers.model[ranger];
  world.rangers.measured_tick[ranger] = tick;
  if (kind.beams == 0) return;
  if (kind.noisy) {
    double* range = scratch.range.data() + scratch.first_beam;
    for (std::uint32_t i = 0; i < world.rangers.sensor_count[ranger]; ++i) {
      const scene::RangerSensorDesc& sensor = world.desc(model).sensors[i];
      Rng rng(world.seed(), tick, {Purpose::kRangeNoise, world.id(model).value, i});
      for (std::uint32_t k = 0; k < sensor.samples; ++k, ++range)
        if (*range < sensor.range_max) *range = noisy(*range, sensor, rng);
    }
  }
  // The beams of a ranger's sensors are consecutive.
  float* const ranges = world.sensors.ranges.data() + world.sensors.first_beam[first_sensor];
  float* const intensities = world.sensors.intensities.data() + world.sensors.first_beam[first_sensor];
  const double *range = scratch.range.data() + scratch.first_beam,
               *intensity = scratch.intensity.data() + scratch.first_beam, *low = kind.range_min.data(),
               *high = kind.range_max.data();
  for (std::uint32_t k = 0; k < kind.beams; ++k) {
    const double above = range[k] < low[k] ? low[k] : range[k];
    ranges[k] = static_cast<float>(above > high[k] ? high[k] : above);
  }
  for (std::uint32_t k = 0; k < kind.beams; ++k) intensities[k] = static_cast<float>(intensity[k]);
}

std::size_t RangerSense::Scratch::gather(const DiscIndex& index, const Sector& sector) {
  std::size_t count = 0;
  const DiscIndex::Places& places = index.places();
  const double *const from_x = places.x.data(), *const from_y = places.y.data();
  const double *const z_min = places.z_min.data(), *const z_max = places.z_max.data();
  double *const to_x = x.data(), *const to_y = y.data();
  std::uint32_t* const to_place = place.data();
  const Sector s = sector;
  const double far = (s.reach + index.radius_max()) * (s.reach + index.radius_max()) + kMargin;
  index.runs(s.p, s.reach, s.z_low, s.z_high, [&](std::uint32_t begin, std::uint32_t end) {
    std::size_t at = count;
    for (std::uint32_t i = begin; i < end; ++i) {  // without branches: what does not matter is overwritten
      const double dx = from_x[i] - s.p.x, dy = from_y[i] - s.p.y;
      to_x[at] = dx;
      to_y[at] = dy;
      to_place[at] = i;
      at += (z_min[i] <= s.z_high) & (z_max[i] >= s.z_low) & (dx * dx + dy * dy <= far) &
            (dx * s.ahead.x + dy * s.ahead.y >= s.behind);
    }
    count = at;
  });
  return count;
}

void RangerSense::run_jitter(const Space& space, const View& view, const Jitter& jitter, double bearing,
                             Scratch& scratch) {
  const Pose X_WS = geom::compose(view.X_WM, jitter.X_MS);
  const Rotation ahead = Rotation::of(X_WS.a + bearing);
  const Ray ray{X_WS.xy(), {ahead.c, ahead.s}, view.X_WM.z + jitter.z, jitter.range_max, view.root};
  const Hit hit = cast(space, ray, [&](std::uint32_t row) { return space.solids.ranger_return[row] >= 0; });
  scratch.range[scratch.first_beam + jitter.beam] = hit.range;
  if (hit.solid != world::ModelRow::kNone)
    scratch.intensity[scratch.first_beam + jitter.beam] = space.solids.ranger_return[hit.solid];
}

}  // namespace playhouse::stage
