/// A ranger with several rings as interface pointcloud3d (docs/drivers.md).

#include "playhouse/wire/generated/pointcloud3d.h"

#include <algorithm>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/ranging/scan.h"
#include "playhouse/geom/orientation.h"
#include "playhouse/scene/forms/sensor_rays.h"

namespace playhouse::drivers {
namespace {

namespace cloud = wire::pointcloud3d;
using geom::Vec3;

/// Origin and unit vector of a beam, in the ranger.
struct Line {
  Vec3 p, d;
};

Line line_of(const scene::RangerSensorDesc& sensor, std::uint32_t sample, double elevation) {
  const geom::SinCos across = geom::sincos(sensor.X_BS.a + scene::bearing_of(sensor, sample)),
                     up = geom::sincos(elevation);
  return {{sensor.X_BS.x, sensor.X_BS.y, sensor.X_BS.z + 0.5 * sensor.size.z},
          {up.cos * across.cos, up.cos * across.sin, up.sin}};
}

/// Beams of a sensor: ring by ring, then level ones.
std::vector<Line> lines_of(const scene::RangerSensorDesc& sensor) {
  std::vector<Line> lines;
  for (std::uint32_t ring = 0; ring <= sensor.rings; ++ring) {
    const double elevation = ring < sensor.rings ? scene::elevation_of(sensor, ring) : 0;
    for (std::uint32_t sample = 0; sample < sensor.samples; ++sample)
      lines.push_back(line_of(sensor, sample, elevation));
  }
  return lines;
}

void add_points(std::span<const Line> lines, const Beams& beams, double range_max, cloud::Data& data) {
  for (std::size_t k = 0; k < beams.ranges.size(); ++k) {
    const double range = static_cast<double>(beams.ranges[k]);
    if (range >= range_max) continue;
    const Vec3 p = lines[k].p + range * lines[k].d;
    const auto gray = static_cast<std::uint8_t>(std::clamp(beams.intensities[k], 0.0f, 255.0f));
    data.points.push_back({{p.x, p.y, p.z}, {255, gray, gray, gray}});
  }
}

class PointCloud final : public SimulatedDevice {
 public:
  PointCloud(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {
    for (const scene::RangerSensorDesc& sensor : simulation.world().desc(model).sensors)
      sensors_.push_back({lines_of(sensor), sensor.samples, sensor.rings, sensor.range_max});
  }

  std::span<const Served> served() const override { return {}; }
  void request(const device::Message&, device::Replier) override {}

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const std::optional<RangerRows> rows = fresh_rows(world, model());
    if (!rows) return;
    cloud::Data data;
    std::span<const float> ring_ranges(world.rangers.ring_ranges[rows->ranger]);
    std::span<const float> ring_intensities(world.rangers.ring_intensities[rows->ranger]);
    for (std::uint32_t i = 0; i < sensors_.size(); ++i) {
      const Sensor& sensor = sensors_[i];
      const world::SensorRow row = rows->sensors[i];
      const std::size_t count = std::size_t{sensor.samples} * sensor.rings;
      const std::span<const Line> lines(sensor.lines);
      const bool has_rings =
          sensor.rings > 1 && ring_ranges.size() >= count && ring_intensities.size() >= count;
      if (has_rings) {
        const Beams all{ring_ranges.first(count), ring_intensities.first(count)};
        ring_ranges = ring_ranges.subspan(count);
        ring_intensities = ring_intensities.subspan(count);
        add_points(lines, all, static_cast<double>(static_cast<float>(sensor.range_max)), data);
      } else {  // an engine or a sensor with level beams only
        add_points(lines.subspan(count), beams(world, row),
                   static_cast<double>(static_cast<float>(sensor.range_max)), data);
      }
    }
    publish(world, cloud::kDataState, data, out);
  }

 private:
  struct Sensor {
    std::vector<Line> lines;
    std::uint32_t samples = 0, rings = 1;
    double range_max = 0;
  };
  std::vector<Sensor> sensors_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_pointcloud3d_device(run::Simulation& simulation,
                                                          world::ModelRow model) {
  return std::make_unique<PointCloud>(simulation, model);
}

}  // namespace playhouse::drivers
