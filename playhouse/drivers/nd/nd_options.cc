#include "playhouse/drivers/nd/nd_options.h"

#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

Result<NdOptions> nd_options(const scene::CfgSection& section) {
  NdOptions options;
  SectionFields fields(section);
  options.goal_distance = fields.length("goal_tol", options.goal_distance, 0, 0);
  options.goal_angle = fields.angle("goal_tol", options.goal_angle, 1);
  options.max_speed = fields.length("max_speed", options.max_speed, 0, 0);
  options.max_turn_rate = fields.angle("max_speed", options.max_turn_rate, 1);
  options.min_speed = fields.length("min_speed", options.min_speed, 0, 0);
  options.min_turn_rate = fields.angle("min_speed", options.min_turn_rate, 1);
  fields.expect(options.min_speed <= options.max_speed && options.min_turn_rate <= options.max_turn_rate,
                "min_speed", "is not above max_speed");
  options.avoid_distance = fields.length("avoid_dist", options.avoid_distance, 0.001);
  options.safety_distance = fields.length("safety_dist", options.safety_distance, 0);

  options.wait_on_stall = section.flag("wait_on_stall", options.wait_on_stall);
  options.rotate_stuck_time = fields.number("rotate_stuck_time", options.rotate_stuck_time);
  options.translate_stuck_time = fields.number("translate_stuck_time", options.translate_stuck_time);
  options.translate_stuck_distance =
      fields.length("translate_stuck_dist", options.translate_stuck_distance, 0);
  options.translate_stuck_angle = fields.angle("translate_stuck_angle", options.translate_stuck_angle);

  options.laser_buffer = fields.integer("laser_buffer", options.laser_buffer, 1, 1000);
  options.sonar_buffer = fields.integer("sonar_buffer", options.sonar_buffer, 1, 1000);
  for (std::size_t i = 0; i < section.count("sonar_bad_transducers"); ++i)
    options.bad_sonars.push_back(section.integer("sonar_bad_transducers", 0, i));
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace playhouse::drivers
