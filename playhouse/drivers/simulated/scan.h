#pragma once

/// What a ranger measured, in the shapes that the interfaces ranger, laser and sonar want.

#include <optional>
#include <span>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// A ranger and the sensor rows that belong to it.
struct RangerRows {
  world::RangerRow ranger;
  std::uint32_t first_sensor = 0;
  std::uint32_t sensor_count = 0;
};

/// `model` is of kind kRanger.
RangerRows ranger_rows(const world::World& world, world::ModelRow model);

/// Those of a model, if it is still there and has measured in this very tick with any sensors.
std::optional<RangerRows> fresh_rows(const world::World& world, world::ModelId model);

/// The first of its sensors with more than one sample; none if there is no such sensor.
world::SensorRow scanner_of(const world::World& world, world::ModelRow model);

/// Angle between neighbouring beams [rad]; the whole field of view for a single beam.
double angular_resolution(const scene::RangerSensorDesc& sensor);

/// One reading of a ranger: a distance [m] and what came back [1].
struct Reading {
  double range = 0;
  double intensity = 0;
};

/// One sensor: all its beams, rightmost first. Several sensors: the nearest reading of each, in the file's
/// order.
void readings(const world::World& world, const RangerRows& rows, std::vector<Reading>& out);

/// What the beams of a sensor measured: distances [m] and what came back [1].
struct Beams {
  std::span<const float> ranges, intensities;
};
/// All beams of one sensor, rightmost first.
Beams beams(const world::World& world, world::SensorRow sensor);

}  // namespace playhouse::drivers
