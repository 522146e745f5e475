#pragma once

/// Beam directions of a ranger's sensor in its frame: bearing and elevation.
/// Rings from the lowest to the highest, beams in a ring from right to left.

#include <cmath>
#include <cstdint>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// Of a beam in its ring; a single one points ahead.  [rad]
inline double bearing_of(const RangerSensorDesc& sensor, std::uint32_t beam) {
  if (sensor.samples <= 1) return 0;
  return -0.5 * sensor.fov + sensor.fov * beam / (sensor.samples - 1);
}

/// Of a ring; a single one is horizontal.  [rad]
inline double elevation_of(const RangerSensorDesc& sensor, std::uint32_t ring) {
  if (sensor.rings <= 1) return 0;
  return sensor.ring_lowest + (sensor.ring_highest - sensor.ring_lowest) * ring / (sensor.rings - 1);
}

/// The ring nearest to horizontal, the upper one of two: reported by `laser` and `ranger`.
inline std::uint32_t level_ring(const RangerSensorDesc& sensor) {
  constexpr double kEqual = 1e-9;  // rad
  std::uint32_t level = 0;
  for (std::uint32_t ring = 1; ring < sensor.rings; ++ring)
    if (std::fabs(elevation_of(sensor, ring)) <= std::fabs(elevation_of(sensor, level)) + kEqual)
      level = ring;
  return level;
}

}  // namespace playhouse::scene
