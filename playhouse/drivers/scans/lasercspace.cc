#include "playhouse/drivers/scans/lasercspace.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "playhouse/drivers/scans/laser_filter.h"
#include "playhouse/geom/pose.h"
#include "playhouse/geom/trig.h"

namespace playhouse::drivers {

namespace {

/// Where on the ray from the laser in the direction `u`, a unit vector, a disc first touches the point; none where it
/// does not, or is behind the laser.
std::optional<double> touch(geom::Vec2 u, geom::Vec2 point, double radius) {
  const double along = geom::dot(u, point), beside = geom::cross(u, point);
  if (along < 0 || std::fabs(beside) > radius) return std::nullopt;
  return along - std::sqrt(radius * radius - beside * beside);
}

}  // namespace

std::optional<wire::laser::Data> LaserCSpace::scan(const wire::laser::Data& whole) const {
  const double from = whole.min_angle, angle_step = whole.resolution;
  if (!std::isfinite(from) || !std::isfinite(angle_step) || whole.ranges.size() > kMostBeams)
    return std::nullopt;
  std::vector<geom::Vec2> directions, ends;
  wire::laser::Data made = whole;
  for (std::size_t i = 0; i < whole.ranges.size(); ++i) {
    const geom::SinCos heading = geom::sincos(geom::normalize(from + static_cast<double>(i) * angle_step));
    directions.push_back({heading.cos, heading.sin});
    // What is no number is no range.
    made.ranges[i] = whole.ranges[i] > 0 ? std::min(whole.ranges[i], std::max(whole.max_range, 0.0f)) : 0.0f;
    if (made.ranges[i] > 0 && i % static_cast<std::size_t>(step) == 0)
      ends.push_back(static_cast<double>(made.ranges[i]) * directions.back());
  }
  for (std::size_t i = 0; i < directions.size(); ++i) {
    double free = static_cast<double>(made.ranges[i]) - radius;
    for (const geom::Vec2 end : ends)
      if (const std::optional<double> touched = touch(directions[i], end, radius))
        free = std::min(free, *touched);
    made.ranges[i] = static_cast<float>(std::max(free, 0.0));
  }
  return made;
}

Result<LaserCSpace> laser_cspace_options(SectionFields fields) {
  LaserCSpace options;
  options.radius = fields.length({"radius", "Of the robot, about the laser."}, options.radius, 0);
  options.step =
      fields.integer({"step", "The ends of every so many beams count as obstacles."}, options.step, 1, 1000);
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

constinit const DriverDefinition kLaserCSpaceDriver{
    .name = "lasercspace",
    .doc = "A laser with how far a round robot could drive in the direction of each beam of another one.",
    .provides = kLaserFilterProvides,
    .uses = kLaserFilterUses,
    .read_options = reading<laser_cspace_options>,
    .make = make_laser_filter<laser_cspace_options, LaserCSpace>,
};

}  // namespace playhouse::drivers
