#include "playhouse/drivers/interfaces/scan.h"

namespace playhouse::drivers {
namespace {

Reading reading(const world::Sensors& sensors, std::uint32_t beam) {
  return {static_cast<double>(sensors.ranges[beam]), static_cast<double>(sensors.intensities[beam])};
}

/// A sonar reports the nearest echo within its cone.
Reading nearest(const world::Sensors& sensors, std::uint32_t sensor) {
  const std::uint32_t first = sensors.first_beam[sensor];
  Reading best = reading(sensors, first);
  for (std::uint32_t beam = first + 1; beam < first + sensors.beam_count[sensor]; ++beam) {
    if (static_cast<double>(sensors.ranges[beam]) < best.range) best = reading(sensors, beam);
  }
  return best;
}

}  // namespace

RangerRows ranger_rows(const world::World& world, world::ModelRow model) {
  const world::RangerRow ranger{world.models.part[model.index]};
  return {ranger, world.rangers.first_sensor[ranger.index], world.rangers.sensor_count[ranger.index]};
}

std::optional<RangerRows> fresh_rows(const world::World& world, world::ModelId id) {
  const world::ModelRow model = world.row(id);
  if (!model) return std::nullopt;
  const RangerRows rows = ranger_rows(world, model);
  if (rows.sensor_count == 0 || world.rangers.measured_tick[rows.ranger.index] != world.tick())
    return std::nullopt;
  return rows;
}

world::SensorRow scanner_of(const world::World& world, world::ModelRow model) {
  const RangerRows rows = ranger_rows(world, model);
  for (std::uint32_t sensor = rows.first_sensor; sensor < rows.first_sensor + rows.sensor_count; ++sensor) {
    if (world.sensors.beam_count[sensor] > 1) return {sensor};
  }
  return {};
}

double angular_resolution(const scene::RangerSensorDesc& sensor) {
  return sensor.samples > 1 ? sensor.fov / (sensor.samples - 1) : sensor.fov;
}

Beams beams(const world::World& world, world::SensorRow sensor) {
  const std::uint32_t first = world.sensors.first_beam[sensor.index];
  const std::uint32_t count = world.sensors.beam_count[sensor.index];
  return {std::span(world.sensors.ranges).subspan(first, count),
          std::span(world.sensors.intensities).subspan(first, count)};
}

void readings(const world::World& world, const RangerRows& rows, std::vector<Reading>& out) {
  out.clear();
  if (rows.sensor_count == 1) {
    const Beams all = beams(world, {rows.first_sensor});
    for (std::size_t i = 0; i < all.ranges.size(); ++i)
      out.push_back({static_cast<double>(all.ranges[i]), static_cast<double>(all.intensities[i])});
    return;
  }
  for (std::uint32_t i = 0; i < rows.sensor_count; ++i) {
    out.push_back(nearest(world.sensors, rows.first_sensor + i));
  }
}

}  // namespace playhouse::drivers
