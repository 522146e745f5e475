#include "playhouse/arena/sensing/lidar_beams.h"

#include <algorithm>
#include <cmath>

#include "playhouse/arena/sensing/optics.h"
#include "playhouse/scene/forms/sensor_rays.h"

namespace playhouse::arena {
namespace {

using geom::Vec3;

// A cone misses no upright post of this width within its range, unless that takes more than kMostSteps.
constexpr double kPost = 0.05;  // m
// Of the width of a round post, what faces a ray within the 60 degrees that return an echo (lidar_sense.cc).
constexpr double kShareFacing = 0.8660254037844386;
constexpr double kMostSteps = 256;  // from the right to the left side

/// Unit vector at angle `off` from a bearing, rotated by `around` about it; 0: up.  [rad]
Vec3 direction(double bearing, double off, double around) {
  const geom::SinCos b = geom::sincos(bearing), o = geom::sincos(off), r = geom::sincos(around);
  const Vec3 ahead{b.cos, b.sin, 0}, left{-b.sin, b.cos, 0}, up{0, 0, 1};
  return o.cos * ahead + o.sin * (r.cos * up + r.sin * left);
}

/// Detection threshold: the echo of a surface with 10 % reflectance at range_dark.
double weakest_of(const scene::RangerSensorDesc& sensor) {
  return echo_power(0.1, sensor.range_dark);
}

/// Steps of a cone from its right to its left side, `half` to either. Even, so that one ray is the axis.
std::uint32_t steps_of(double half, double range_max) {
  const double wanted = std::ceil(half * range_max / (kPost * kShareFacing));
  return 2 * static_cast<std::uint32_t>(std::clamp(wanted, 1.0, kMostSteps / 2));
}

/// A level fan, then a ray on the upper and one on the lower rim. `ray` has what they share.
void add_cone(LidarBeams& all, LidarBeams::BeamRay ray, double bearing,
              const scene::RangerSensorDesc& sensor) {
  const double half = std::min(0.5 * sensor.fov, 0.5 * geom::kPi);
  const std::uint32_t steps = steps_of(half, sensor.range_max);
  for (std::uint32_t i = 0; i <= steps; ++i) {
    ray.is_off_axis = 2 * i != steps;
    ray.begins_fan = i == 0;
    ray.d = direction(bearing + (2.0 * i / steps - 1) * half, 0, 0);
    all.rays.push_back(ray);
  }
  ray.is_off_axis = true;
  for (const double around : {0.0, geom::kPi}) {
    ray.begins_fan = around == 0;
    ray.d = direction(bearing, half, around);
    all.rays.push_back(ray);
  }
}

void add_sensor(LidarBeams& all, const scene::RangerSensorDesc& sensor, const geom::Pose& X_MB,
                std::uint32_t number) {
  const geom::Pose X_MS = geom::compose(X_MB, sensor.X_BS);
  const auto first = static_cast<std::uint32_t>(all.beams());
  LidarBeams::BeamRay ray{.p = {X_MS.x, X_MS.y, X_MS.z + 0.5 * sensor.size.z},
                          .d = {},
                          .range_max = static_cast<float>(sensor.range_max),
                          .is_turned = sensor.noise_angular > 0,
                          .sensor = number};
  for (std::uint32_t ring = 0; ring < sensor.rings; ++ring)
    for (std::uint32_t sample = 0; sample < sensor.samples; ++sample) {
      ray.sample = ring * sensor.samples + sample;
      ray.beam = first + ray.sample;
      ray.begins_fan = sample == 0;
      ray.d = direction(X_MS.a + scene::bearing_of(sensor, sample), scene::elevation_of(sensor, ring), 0);
      all.rays.push_back(ray);
    }
  if (sensor.samples == 1 && sensor.rings == 1 && sensor.fov > 0) {
    all.rays.pop_back();  // the axis is in the fan, where neighbours in direction are cast together
    add_cone(all, ray, X_MS.a, sensor);
  }
  const std::size_t beams = std::size_t{sensor.samples} * sensor.rings;
  all.range_min.insert(all.range_min.end(), beams, std::min(sensor.range_min, sensor.range_max));
  all.range_max.insert(all.range_max.end(), beams, sensor.range_max);
  const bool is_light = sensor.errors == scene::RangerErrors::kLidar;
  all.sensors.push_back({first, sensor.samples, sensor.rings, scene::level_ring(sensor),
                         is_light ? weakest_of(sensor) : 0, sensor.noise_weak});
  all.is_light = all.is_light || is_light;
  all.is_noisy = all.is_noisy || sensor.noise_constant > 0 || sensor.noise_proportional > 0;
}

}  // namespace

LidarBeams beams_of(const scene::ModelDesc& ranger) {
  LidarBeams all;
  for (std::uint32_t i = 0; i < ranger.sensors.size(); ++i)
    add_sensor(all, ranger.sensors[i], ranger.X_MB, i);
  return all;
}

}  // namespace playhouse::arena
