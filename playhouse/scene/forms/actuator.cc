#include "playhouse/scene/forms/actuator.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "playhouse/scene/properties.h"

namespace playhouse::scene {

Axis axis_of(const ActuatorDesc& desc) {
  if (desc.type == ActuatorType::kRotational) return {0, 0, desc.axis_z < 0 ? -1.0 : 1.0};
  // Scaled by the largest component first, against overflow and underflow.
  const double largest = std::max({std::fabs(desc.axis_x), std::fabs(desc.axis_y), std::fabs(desc.axis_z)});
  if (largest == 0) return {1, 0, 0};
  const Axis axis{desc.axis_x / largest, desc.axis_y / largest, desc.axis_z / largest};
  const double length = std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
  return {axis.x / length, axis.y / length, axis.z / length};
}

geom::Pose way_along(const ActuatorDesc& desc, double way) {
  const Axis axis = axis_of(desc);
  if (desc.type == ActuatorType::kRotational) return {0, 0, 0, geom::normalize(axis.z * way)};
  return {axis.x * way, axis.y * way, axis.z * way, 0};
}

double within_reach(const ActuatorDesc& desc, double position) {
  return std::max(desc.min_position, std::min(position, desc.max_position));
}

void check_actuator(const Properties& properties, ActuatorDesc& desc) {
  config::Warnings& warnings = properties.state().warnings;
  const bool tilted = desc.axis_x != 0 || desc.axis_y != 0;
  if (desc.type == ActuatorType::kRotational && tilted)
    warnings.add(config::Warning::kValue, properties.where("axis"),
                 "nothing turns about another axis than z; [0 0 " +
                     std::string(desc.axis_z < 0 ? "-1" : "1") + "] is meant");
  if (desc.max_position < desc.min_position) {
    warnings.add(config::Warning::kValue, properties.where("max_position"),
                 "\"max_position\" is below \"min_position\"; it does not move");
    desc.max_position = desc.min_position;
  }
  const double start = within_reach(desc, desc.start_position);
  if (start != desc.start_position && properties.has("start_position"))
    warnings.add(config::Warning::kValue, properties.where("start_position"),
                 "\"start_position\" is beyond its ends; " +
                     std::string(start == desc.max_position ? "\"max_position\"" : "\"min_position\"") +
                     " is meant");
  desc.start_position = start;
}

}  // namespace playhouse::scene
