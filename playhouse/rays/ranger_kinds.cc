#include "playhouse/rays/ranger_kinds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "playhouse/bodies/space.h"
#include "playhouse/scene/forms/sensor_rays.h"

namespace playhouse::rays {
namespace {

constexpr std::uint32_t kScanBeams = 8;  // sensors with fewer beams are traced as bundles

geom::Vec2 unit(double angle) {
  const geom::SinCos sc = geom::sincos(angle);
  return {sc.cos, sc.sin};
}

Scan make_scan(const scene::RangerSensorDesc& sensor, const geom::Pose& X_MS, double z,
               std::uint32_t first_beam) {
  Scan scan;
  scan.X_MS = X_MS;
  scan.z = z;
  scan.range_max = sensor.range_max;
  scan.first_beam = first_beam;
  scan.fov = sensor.fov;
  scan.step = sensor.fov / (sensor.samples - 1);
  scan.count = sensor.samples;
  for (std::uint32_t beam = 0; beam < sensor.samples; ++beam) {
    const geom::Vec2 d = unit(scene::bearing_of(sensor, beam));
    scan.x.push_back(d.x);
    scan.y.push_back(d.y);
  }
  // A pad of NaN: vector loops write past a scan's beams, into those of the next, without changing them.
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  scan.x.resize(scan.count + Scan::kPad, kNowhere);
  scan.y.resize(scan.count + Scan::kPad, kNowhere);
  return scan;
}

void add_ray(Bundle& bundle, const scene::RangerSensorDesc& sensor, const geom::Pose& X_MS, double z,
             std::uint32_t sample, std::uint32_t beam) {
  bundle.p.push_back(X_MS.xy());
  bundle.d.push_back(unit(X_MS.a + bearing_of(sensor, sample)));
  bundle.z.push_back(z);
  bundle.range_max.push_back(sensor.range_max);
  bundle.beam.push_back(beam);
}

double distance_to_ray(geom::Vec2 center, geom::Vec2 p, geom::Vec2 d, double range) {
  const double t = std::clamp(geom::dot(d, center - p), 0.0, range);
  const geom::Vec2 off = center - (p + t * d);
  return std::sqrt(geom::dot(off, off));
}

/// find_bodies() works in single precision, on fixed-point units of DiscIndex.
constexpr double kSinglePrecision = 1e-3;  // share of a cell's width; a smaller one of the square's
constexpr double kWholeUnits = 4 / bodies::DiscIndex::kPerMetre;  // m

void measure_reach(Bundle& bundle) {
  bundle.z_min = *std::min_element(bundle.z.begin(), bundle.z.end());
  bundle.z_max = *std::max_element(bundle.z.begin(), bundle.z.end());
  bundle.reach = 0;
  for (std::size_t k = 0; k < bundle.rays(); ++k)
    bundle.reach =
        std::max(bundle.reach, std::sqrt(geom::dot(bundle.p[k], bundle.p[k])) + bundle.range_max[k]);
  bundle.reach += bodies::kMargin;
}

Bundle::Table make_table(const Bundle& bundle, double body_radius) {
  Bundle::Table table{body_radius, 0, 0, {}};
  table.half = (1 + kSinglePrecision) * (bundle.reach + body_radius + bodies::kMargin) + kWholeUnits;
  table.cell = 2 * table.half / Bundle::kCells;
  table.meets.assign(Bundle::kSide * Bundle::kRow + 1, 0);
  const double near = body_radius + (0.7072 + kSinglePrecision) * table.cell + kWholeUnits;
  for (std::size_t row = 0; row < Bundle::kCells; ++row) {
    for (std::size_t column = 0; column < Bundle::kCells; ++column) {
      const geom::Vec2 middle{(static_cast<double>(column) + 0.5) * table.cell - table.half,
                              (static_cast<double>(row) + 0.5) * table.cell - table.half};
      std::uint16_t& rays = table.meets[(row + 1) * Bundle::kRow + column + 1];
      for (std::size_t k = 0; k < bundle.rays(); ++k)
        if (distance_to_ray(middle, bundle.p[k], bundle.d[k], bundle.range_max[k]) <= near)
          rays = static_cast<std::uint16_t>(rays | 1u << k);
    }
  }
  return table;
}

/// Makes the tables for these radii, except those that are there.
void fit_tables(Bundle& bundle, std::span<const double> radii) {
  bundle.tables.resize(std::max(bundle.tables.size(), radii.size()));
  for (std::size_t size = 0; size < radii.size(); ++size)
    if (bundle.tables[size].meets.empty() || bundle.tables[size].body_radius != radii[size])
      bundle.tables[size] = make_table(bundle, radii[size]);
}

void add_sensor(RangerKind& kind, const scene::RangerSensorDesc& sensor, const geom::Pose& X_MB,
                std::uint32_t number) {
  const geom::Pose X_MS = geom::compose(X_MB, sensor.X_BS);
  const double z = X_MS.z + 0.5 * sensor.size.z;
  if (sensor.noise_angular > 0) {
    for (std::uint32_t sample = 0; sample < sensor.samples; ++sample)
      kind.jitters.push_back(
          {X_MS, z, sensor.range_max, bearing_of(sensor, sample), kind.beams + sample, number, sample});
  } else if (sensor.samples >= kScanBeams && sensor.fov > 0) {
    kind.scans.push_back(make_scan(sensor, X_MS, z, kind.beams));
  } else {
    for (std::uint32_t sample = 0; sample < sensor.samples; ++sample) {
      if (kind.bundles.empty() || kind.bundles.back().rays() == Bundle::kRays) kind.bundles.emplace_back();
      add_ray(kind.bundles.back(), sensor, X_MS, z, sample, kind.beams + sample);
    }
  }
  kind.beams += sensor.samples;
  kind.range_min.insert(kind.range_min.end(), sensor.samples, std::min(sensor.range_min, sensor.range_max));
  kind.range_max.insert(kind.range_max.end(), sensor.samples, sensor.range_max);
  kind.noisy |= sensor.noise_constant > 0 || sensor.noise_proportional > 0;
}

RangerKind make_kind(const scene::ModelDesc& desc, std::span<const double> radii) {
  RangerKind kind;
  for (std::uint32_t i = 0; i < desc.sensors.size(); ++i) add_sensor(kind, desc.sensors[i], desc.X_MB, i);
  for (Bundle& bundle : kind.bundles) {
    measure_reach(bundle);
    fit_tables(bundle, radii);
  }
  return kind;
}

/// Key of a ranger kind: equal for rangers with equal sensors.
std::vector<double> signature(const scene::ModelDesc& desc) {
  std::vector<double> all{desc.X_MB.x, desc.X_MB.y, desc.X_MB.z, desc.X_MB.a};
  for (const scene::RangerSensorDesc& s : desc.sensors)
    all.insert(all.end(),
               {s.X_BS.x, s.X_BS.y, s.X_BS.z, s.X_BS.a, s.size.z, s.range_min, s.range_max, s.fov,
                static_cast<double>(s.samples), s.noise_constant, s.noise_proportional, s.noise_angular});
  return all;
}

}  // namespace

void RangerKinds::populate(const world::World& world, std::span<const double> radii) {
  constexpr double kTooLarge = 2;  // a table for radii so many times larger names too many rays
  radii_.resize(std::max(radii_.size(), radii.size()));
  bool fits = true;
  for (std::size_t size = 0; size < radii.size(); ++size) {
    const bool has_none = radii[size] == 0;
    if (has_none || (radii[size] <= radii_[size] && radii_[size] <= kTooLarge * radii[size])) continue;
    radii_[size] = radii[size];
    fits = false;
  }
  if (!fits)
    for (RangerKind& kind : kinds)
      for (Bundle& bundle : kind.bundles) fit_tables(bundle, radii_);
  std::vector<std::uint32_t> of_desc(world.scene().models.size(), world::RangerRow::kNone);
  of_ranger.clear();
  of_ranger.reserve(world.rangers.size());
  for (const world::ModelRow model : world.rangers.model) {
    std::uint32_t& kind = of_desc[world.models.desc[model]];
    if (kind == world::RangerRow::kNone) kind = find_kind(world.desc(model));
    of_ranger.push_back(kind);
  }
}

std::uint32_t RangerKinds::find_kind(const scene::ModelDesc& desc) {
  const auto [entry, is_new] = known_.try_emplace(signature(desc), static_cast<std::uint32_t>(kinds.size()));
  if (is_new) kinds.push_back(make_kind(desc, radii_));
  return entry->second;
}

}  // namespace playhouse::rays
