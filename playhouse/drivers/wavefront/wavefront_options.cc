#include "playhouse/drivers/wavefront/wavefront_options.h"

#include <fmt/format.h>

#include "playhouse/drivers/section_fields.h"

namespace playhouse::drivers {

Result<WavefrontOptions> wavefront_options(const scene::CfgSection& section) {
  WavefrontOptions options;
  SectionFields fields(section);
  PlanOptions& plan = options.plan;
  plan.safety_distance = fields.length("safety_dist", plan.safety_distance, 0);
  plan.max_radius = fields.length("max_radius", plan.max_radius, 0);
  plan.penalty = fields.number("dist_penalty", plan.penalty);
  fields.expect(plan.penalty <= kMostPenalty, "dist_penalty", fmt::format("is {} at most", kMostPenalty));
  options.distance_epsilon = fields.length("distance_epsilon", options.distance_epsilon, 0);
  options.angle_epsilon = fields.angle("angle_epsilon", options.angle_epsilon);
  options.replan_distance = section.length("replan_dist_thresh", options.replan_distance);
  options.replan_time = section.number("replan_min_time", options.replan_time);
  options.turns = section.flag("add_rotational_waypoints", options.turns);
  options.refresh_map = section.flag("force_map_refresh", options.refresh_map);
  section.flag("request_map", true);    // maps are always requested
  section.filename("cspace_file", "");  // the costs of a map take less time than to read them
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace playhouse::drivers
