#pragma once

/// Measurements of a ranger, in the formats of interfaces ranger, laser, sonar and ir.

#include <optional>
#include <span>
#include <vector>

#include "playhouse/wire/generated/common.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// A ranger and its sensors.
struct RangerRows {
  world::RangerRow ranger;
  RowsOf<world::SensorTable> sensors;
};

/// `model` is of kind kRanger.
RangerRows ranger_rows(const world::World& world, world::ModelRow model);

/// Those of a model, if it still exists and any of its sensors has measured in this very tick.
std::optional<RangerRows> fresh_rows(const world::World& world, world::ModelId model);

/// The first of its sensors with more than one sample; none if there is none.
world::SensorRow scanner_of(const world::World& world, world::ModelRow model);

/// Angle between neighbouring beams [rad]; the whole field of view for a single beam.
double angular_resolution(const scene::RangerSensorDesc& sensor);

/// Update rate of a model.  [Hz]
double measuring_frequency(const world::World& world, world::ModelRow model);

/// Poses of the sensors of a ranger on its robot, in file order; x points along their beams.
std::vector<wire::Pose3d> sensor_poses(const world::World& world, world::ModelRow model);

/// One reading of a ranger: a distance [m] and an intensity [1].
struct Reading {
  double range = 0;
  double intensity = 0;
};

/// One sensor: all its beams, rightmost first. Several
/// sensors: the nearest reading of each, in file order.
void readings(const world::World& world, const RangerRows& rows, std::vector<Reading>& out);

/// Measurements of a sensor's beams: distances [m] and intensities [1].
struct Beams {
  std::span<const float> ranges, intensities;
};
/// All beams of one sensor, rightmost first.
Beams beams(const world::World& world, world::SensorRow sensor);

}  // namespace playhouse::drivers
