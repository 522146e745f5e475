#include "playhouse/drivers/nd/nd_options.h"

#include "playhouse/drivers/nd/nd.h"
#include "playhouse/drivers/refusal.h"

namespace playhouse::drivers {
namespace {

constexpr DeviceText kNdProvides[] = {{"position2d"}};
constexpr DeviceText kNdUses[] = {
    {"position2d", "output", HowMany::kOne, "gets velocities and requests"},
    {"position2d", "input", HowMany::kOne, "gives the pose; may be the output"},
    {"laser", {}, HowMany::kSomeOfThese, "on the robot"},
    {"ranger", {}, HowMany::kSomeOfThese, "on the robot"},
    {"sonar", {}, HowMany::kSomeOfThese, "on the robot"},
};

}  // namespace

constinit const DriverDefinition kNdDriver{
    .name = "nd",
    .doc =
        "Drives a robot to goals and around obstacles that its laser, ranger or sonars detect: Nearness "
        "Diagram.",
    .provides = kNdProvides,
    .uses = kNdUses,
    .properties = kRefusalProperties,
    .read_options = reading<nd_options>,
    .make = make_nd,
};

Result<NdOptions> nd_options(SectionFields fields) {
  NdOptions options;
  options.goal_distance = fields.length({"goal_tol", "Tolerances of arrival."}, options.goal_distance, 0, 0);
  options.goal_angle = fields.angle({"goal_tol"}, options.goal_angle, 1);
  options.max_speed = fields.length({"max_speed", "Upper limits.", "m/s"}, options.max_speed, 0, 0);
  options.max_turn_rate = fields.angle({"max_speed", {}, "deg/s"}, options.max_turn_rate, 1);
  options.min_speed =
      fields.length({"min_speed", "When it drives, and when it turns in place; not above max_speed.", "m/s"},
                    options.min_speed, 0, 0);
  options.min_turn_rate = fields.angle({"min_speed", {}, "deg/s"}, options.min_turn_rate, 1);
  fields.expect(options.min_speed <= options.max_speed && options.min_turn_rate <= options.max_turn_rate,
                "min_speed", "is not above max_speed");
  options.avoid_distance =
      fields.length({"avoid_dist", "Obstacles nearer than this to the robot's body are avoided."},
                    options.avoid_distance, 0.001);
  options.safety_distance = fields.length({"safety_dist", "The body counts as larger by this on all sides."},
                                          options.safety_distance, 0);

  options.wait_on_stall = fields.flag(
      {"wait_on_stall",
       "1: it stands while the input's STATE has stall 1, and this is not time without progress."},
      options.wait_on_stall);
  options.rotate_stuck_time = fields.number(
      {"rotate_stuck_time",
       "Stuck if in this time its turn to the goal's heading has come no degree nearer to it.", "s"},
      options.rotate_stuck_time);
  options.translate_stuck_time = fields.number({"translate_stuck_time",
                                                "Stuck if in this time it has neither driven "
                                                "translate_stuck_dist nor turned by translate_stuck_angle.",
                                                "s"},
                                               options.translate_stuck_time);
  options.translate_stuck_distance = fields.length({"translate_stuck_dist", "See translate_stuck_time."},
                                                   options.translate_stuck_distance, 0);
  options.translate_stuck_angle =
      fields.angle({"translate_stuck_angle", "See translate_stuck_time."}, options.translate_stuck_angle);

  options.laser_buffer = fields.integer(
      {"laser_buffer", "How many of the last scans count, with the obstacles where they were seen."},
      options.laser_buffer, 1, 1000);
  options.sonar_buffer =
      fields.integer({"sonar_buffer", "The same of the sonars."}, options.sonar_buffer, 1, 1000);
  options.bad_sonars =
      fields.integers({"sonar_bad_transducers", "Numbers of sonars, from 0, that are left out."});
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace playhouse::drivers
