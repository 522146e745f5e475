#include "playhouse/bridge/interfaces/ranging/scan.h"

#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {
namespace {

Reading reading(const world::Sensors& sensors, world::BeamRow beam) {
  return {static_cast<double>(sensors.ranges[beam]), static_cast<double>(sensors.intensities[beam])};
}

/// A sonar reports the nearest echo within its cone.
Reading nearest(const world::Sensors& sensors, world::SensorRow sensor) {
  Reading best = reading(sensors, sensors.first_beam[sensor]);
  for (const world::BeamRow beam : beams_of(sensors, sensor)) {
    if (static_cast<double>(sensors.ranges[beam]) < best.range) best = reading(sensors, beam);
  }
  return best;
}

}  // namespace

RangerRows ranger_rows(const world::World& world, world::ModelRow model) {
  const world::RangerRow ranger = world.models.part[model];
  return {ranger, sensors_of(world.rangers, ranger)};
}

std::optional<RangerRows> fresh_rows(const world::World& world, world::ModelId id) {
  const world::ModelRow model = world.row(id);
  if (!model) return std::nullopt;
  const RangerRows rows = ranger_rows(world, model);
  if (rows.sensors.empty() || world.rangers.measured_tick[rows.ranger] != world.tick()) return std::nullopt;
  return rows;
}

world::SensorRow scanner_of(const world::World& world, world::ModelRow model) {
  for (const world::SensorRow sensor : ranger_rows(world, model).sensors)
    if (world.sensors.beam_count[sensor] > 1) return sensor;
  return {};
}

double angular_resolution(const scene::RangerSensorDesc& sensor) {
  return sensor.samples > 1 ? sensor.fov / (sensor.samples - 1) : sensor.fov;
}

double measuring_frequency(const world::World& world, world::ModelRow model) {
  return 1 / (static_cast<double>(world::update_ticks(world, model)) * world.scene().interval);
}

std::vector<wire::Pose3d> sensor_poses(const world::World& world, world::ModelRow model) {
  const geom::SpatialPose X_RB = pose_on_robot(world, model);
  std::vector<wire::Pose3d> poses;
  for (const scene::RangerSensorDesc& sensor : world.desc(model).sensors)
    poses.push_back(pose3d(geom::compose(X_RB, {sensor.X_BS, {}})));
  return poses;
}

Beams beams(const world::World& world, world::SensorRow sensor) {
  const world::BeamRow first = world.sensors.first_beam[sensor];
  const std::uint32_t count = world.sensors.beam_count[sensor];
  return {std::span(world.sensors.ranges.from(first), count),
          std::span(world.sensors.intensities.from(first), count)};
}

void readings(const world::World& world, const RangerRows& rows, std::vector<Reading>& out) {
  out.clear();
  if (rows.sensors.size() == 1) {
    const Beams all = beams(world, rows.sensors.front());
    for (std::size_t i = 0; i < all.ranges.size(); ++i)
      out.push_back({static_cast<double>(all.ranges[i]), static_cast<double>(all.intensities[i])});
    return;
  }
  for (const world::SensorRow sensor : rows.sensors) out.push_back(nearest(world.sensors, sensor));
}

}  // namespace playhouse::drivers
