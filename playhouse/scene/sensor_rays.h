#pragma once

/// Where the beams of a ranger's sensor go, from its pose: a bearing and an elevation each. In rings, from
/// the lowest to the highest, and in each from the right to the left.

#include <cmath>
#include <cstdint>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// Of a beam in its ring; a single one looks ahead.  [rad]
inline double bearing_of(const RangerSensorDesc& sensor, std::uint32_t beam) {
  if (sensor.samples <= 1) return 0;
  return -0.5 * sensor.fov + sensor.fov * beam / (sensor.samples - 1);
}

/// Of a ring; a single one is level.  [rad]
inline double elevation_of(const RangerSensorDesc& sensor, std::uint32_t ring) {
  if (sensor.rings <= 1) return 0;
  return sensor.ring_lowest + (sensor.ring_highest - sensor.ring_lowest) * ring / (sensor.rings - 1);
}

/// The ring that is nearest to level, of two the upper one: what `laser` and `ranger` tell.
inline std::uint32_t level_ring(const RangerSensorDesc& sensor) {
  constexpr double kEqual = 1e-9;  // rad
  std::uint32_t level = 0;
  for (std::uint32_t ring = 1; ring < sensor.rings; ++ring)
    if (std::fabs(elevation_of(sensor, ring)) <= std::fabs(elevation_of(sensor, level)) + kEqual)
      level = ring;
  return level;
}

}  // namespace playhouse::scene
