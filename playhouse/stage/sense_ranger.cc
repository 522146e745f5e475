#include "playhouse/stage/sense_ranger.h"

#include <algorithm>
#include <bit>
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
  std::size_t corners = 0;
  for (std::size_t row = 0; row < solids.moving; ++row) {
    body_radius = std::max(body_radius, solids.radius[row]);
    corners = std::max<std::size_t>(corners, solids.first_vertex[row + 1] - solids.first_vertex[row]);
  }
  kinds_ = make_ranger_kinds(world, body_radius);
  for (const world::ModelRow model : world.rangers.model)
    period_.push_back(ticks_of(world.desc(model).update_interval, world.scene().interval));

  Bench bench;
  std::size_t beams = 0;
  for (const RangerKind& kind : kinds_.kinds) beams = std::max<std::size_t>(beams, kind.beams);
  bench.range.resize(beams);
  bench.intensity.resize(beams);
  bench.discs.resize(solids.moving);
  bench.corner.resize(corners + 1);
  bench.bearing.resize(corners + 1);
  bench.p.resize(Bundle::kRays);
  bench.d.resize(Bundle::kRays);
  benches_.assign(workers, bench);
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
    rays += kinds_.kinds[kinds_.of_ranger[ranger]].beams;
  }
  for (Bench& bench : benches_) bench.stamp.resize(space.walls.edge_count(), 0);
  workers.run(due_.size(), 8, [&](std::size_t begin, std::size_t end) {
    Bench& bench = benches_[workers.current()];
    for (std::size_t i = begin; i < end; ++i) {
      measure(world, space, due_[i], tick, bench);
      finish(world, due_[i], tick, bench);
    }
  });
  return rays;
}

void RangerSense::measure(world::World& world, const Space& space, std::uint32_t ranger, std::uint64_t tick,
                          Bench& bench) const {
  const std::uint32_t model = world.rangers.model[ranger].index;
  const View view{world.models.X_WM[model], world.models.root[model]};
  const RangerKind& kind = kinds_.kinds[kinds_.of_ranger[ranger]];
  std::fill_n(bench.intensity.begin(), kind.beams, 0.0);
  for (const Scan& scan : kind.scans) run_scan(space, view, scan, bench);
  for (const Bundle& bundle : kind.bundles) run_bundle(space, view, bundle, bench);
  for (const Jitter& jitter : kind.jitters) {
    const std::uint32_t sensor = world.rangers.first_sensor[ranger] + jitter.sensor;
    Rng rng(world.seed(), tick, (std::uint64_t{sensor} << 32) + jitter.beam + 1,
            static_cast<std::uint64_t>(world::Stream::kRangeNoise));
    run_jitter(space, view, jitter, jitter.bearing + rng.uniform(-jitter.spread, jitter.spread), bench);
  }
}

/// Noise, limits, and the columns that everyone reads.
void RangerSense::finish(world::World& world, std::uint32_t ranger, std::uint64_t tick,
                         const Bench& bench) const {
  const scene::ModelDesc& desc = world.desc(world.rangers.model[ranger]);
  const std::uint32_t first_sensor = world.rangers.first_sensor[ranger];
  std::size_t from = 0;
  for (std::uint32_t i = 0; i < desc.sensors.size(); ++i) {
    const scene::RangerSensorDesc& sensor = desc.sensors[i];
    const std::uint32_t row = first_sensor + i, beams = world.sensors.beam_count[row];
    float* const ranges = world.sensors.ranges.data() + world.sensors.first_beam[row];
    float* const intensities = world.sensors.intensities.data() + world.sensors.first_beam[row];
    const double low = std::min(sensor.range_min, sensor.range_max), high = sensor.range_max;
    if (sensor.noise_constant > 0 || sensor.noise_proportional > 0) {
      Rng rng(world.seed(), tick, row, static_cast<std::uint64_t>(world::Stream::kRangeNoise));
      for (std::uint32_t k = 0; k < beams; ++k) {
        const double range = bench.range[from + k];
        ranges[k] =
            static_cast<float>(std::clamp(range < high ? noisy(range, sensor, rng) : range, low, high));
      }
    } else {
      for (std::uint32_t k = 0; k < beams; ++k)
        ranges[k] = static_cast<float>(std::clamp(bench.range[from + k], low, high));
    }
    for (std::uint32_t k = 0; k < beams; ++k) intensities[k] = static_cast<float>(bench.intensity[from + k]);
    from += beams;
  }
  world.rangers.measured_tick[ranger] = tick;
}

void RangerSense::run_jitter(const Space& space, const View& view, const Jitter& jitter, double bearing,
                             Bench& bench) {
  const Pose X_WS = geom::compose(view.X_WM, jitter.X_MS);
  const Rotation ahead = Rotation::of(X_WS.a + bearing);
  const Ray ray{X_WS.xy(), {ahead.c, ahead.s}, view.X_WM.z + jitter.z, jitter.range_max, view.root};
  const Hit hit = cast(space, ray, [&](std::uint32_t row) { return space.solids.ranger_return[row] >= 0; });
  bench.range[jitter.beam] = hit.range;
  if (hit.solid != world::ModelRow::kNone)
    bench.intensity[jitter.beam] = space.solids.ranger_return[hit.solid];
}

/// Walls first: what they hide need not be looked at.
void RangerSense::run_bundle(const Space& space, const View& view, const Bundle& bundle, Bench& bench) {
  const Solids& solids = space.solids;
  const Vec2 p_WM = view.X_WM.xy();
  const Rotation rotation = Rotation::of(view.X_WM.a);
  double range[Bundle::kRays], intensity[Bundle::kRays];
  for (std::size_t k = 0; k < bundle.rays(); ++k) {
    bench.p[k] = p_WM + rotation * bundle.p[k];
    bench.d[k] = rotation * bundle.d[k];
    range[k] = bundle.range_max[k];
    intensity[k] = 0;
  }
  const auto keep = [&](std::size_t k, double t, std::uint32_t row) {
    if (t >= range[k] || !view.sees(solids, row) || !at_height(solids, row, view.X_WM.z + bundle.z[k]))
      return;
    range[k] = t;
    intensity[k] = solids.ranger_return[row];
  };

  if (space.walls.count_near(box_about(p_WM, bundle.reach)) > 0)
    for (std::size_t k = 0; k < bundle.rays(); ++k)
      space.walls.along(bench.p[k], bench.d[k], &range[k], [&](const Walls::Edge& edge) {
        keep(k, edge_hit(edge.a - bench.p[k], edge.b - bench.p[k], bench.d[k]), edge.solid);
      });

  const double z_low = view.X_WM.z + bundle.z_min, z_high = view.X_WM.z + bundle.z_max;
  const double per_cell = 1.0 / bundle.cell;
  space.index.near(p_WM, bundle.reach, [&](const DiscIndex::Disc& disc) {
    if (disc.root == view.root || disc.z_max < z_low || disc.z_min > z_high) return;
    const Vec2 c = rotation.inverse(disc.center - p_WM);
    if (std::fabs(c.x) >= bundle.half || std::fabs(c.y) >= bundle.half) return;
    const auto column = static_cast<std::size_t>((c.x + bundle.half) * per_cell);
    const auto row = static_cast<std::size_t>((c.y + bundle.half) * per_cell);
    const std::size_t cell =
        std::min(row, Bundle::kCells - 1) * Bundle::kCells + std::min(column, Bundle::kCells - 1);
    const double radius = disc.radius + kMargin;
    for (std::uint64_t rays = bundle.meets[cell]; rays != 0; rays &= rays - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(rays));
      const Vec2 to_disc = c - bundle.p[k];
      const double ahead = geom::dot(bundle.d[k], to_disc);
      if (ahead < -radius || ahead - radius > range[k]) continue;
      if (std::fabs(geom::cross(bundle.d[k], to_disc)) > radius) continue;
      keep(k, polygon_hit(solids.polygon(disc.row), bench.p[k], bench.d[k]), disc.row);
    }
  });

  for (std::size_t k = 0; k < bundle.rays(); ++k) {
    bench.range[bundle.beam[k]] = range[k];
    bench.intensity[bundle.beam[k]] = intensity[k];
  }
}

}  // namespace playhouse::stage
