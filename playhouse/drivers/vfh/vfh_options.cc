#include "playhouse/drivers/vfh/vfh_options.h"

#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

Result<VfhOptions> vfh_options(const scene::CfgSection& section) {
  VfhOptions options;
  SectionFields fields(section);
  options.cell_size = fields.length("cell_size", options.cell_size, 0.005);
  options.window = fields.integer("window_diameter", options.window, 3, 1001);
  const int sector_angle = fields.integer("sector_angle", 5, 1, 90);
  fields.expect(sector_angle > 0 && 360 % sector_angle == 0, "sector_angle", "divides 360");
  options.sectors = sector_angle > 0 ? 360 / sector_angle : 0;

  const double safety = fields.length("safety_dist_0ms", options.safety_distance.at_rest, 0);
  options.safety_distance = {safety, fields.length("safety_dist_1ms", safety, 0)};
  options.max_speed = fields.length("max_speed", options.max_speed, 0);
  options.max_speed_narrow = fields.length("max_speed_narrow_opening", options.max_speed, 0);
  options.max_speed_wide = fields.length("max_speed_wide_opening", options.max_speed, 0);
  options.max_acceleration = fields.length("max_acceleration", options.max_acceleration, 0.001);
  options.min_turn_rate = fields.angle("min_turnrate", options.min_turn_rate);
  const double turn_rate = fields.angle("max_turnrate_0ms", options.max_turn_rate.at_rest);
  options.max_turn_rate = {turn_rate, fields.angle("max_turnrate_1ms", turn_rate)};
  options.turn_radius_factor = fields.number("min_turn_radius_safety_factor", options.turn_radius_factor);

  const double free_0 = fields.number("free_space_cutoff_0ms", options.free_cutoff.at_rest);
  const double free_1 = fields.number("free_space_cutoff_1ms", free_0);
  options.free_cutoff = {free_0, free_1};
  options.blocked_cutoff = {fields.number("obs_cutoff_0ms", free_0), fields.number("obs_cutoff_1ms", free_1)};
  fields.expect(options.blocked_cutoff.at_rest >= free_0, "obs_cutoff_0ms",
                "is not below free_space_cutoff_0ms");
  fields.expect(options.blocked_cutoff.at_1 >= free_1, "obs_cutoff_1ms",
                "is not below free_space_cutoff_1ms");
  options.weight_desired = fields.number("weight_desired_dir", options.weight_desired);
  options.weight_current = fields.number("weight_current_dir", options.weight_current);

  options.distance_epsilon = fields.length("distance_epsilon", options.distance_epsilon, 0);
  options.angle_epsilon = fields.angle("angle_epsilon", options.angle_epsilon);
  options.escape_speed = section.length("escape_speed", options.escape_speed);
  options.escape_time = fields.number("escape_time", options.escape_time);
  options.escape_turn_rate = fields.angle("escape_max_turnrate", options.escape_turn_rate);
  section.flag("synchronous", false);  // runs are deterministic regardless of threads
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace playhouse::drivers
