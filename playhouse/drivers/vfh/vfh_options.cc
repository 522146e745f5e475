#include "playhouse/drivers/vfh/vfh_options.h"

#include "playhouse/drivers/refusal.h"
#include "playhouse/drivers/vfh/vfh.h"

namespace playhouse::drivers {
namespace {

constexpr DeviceText kVfhProvides[] = {{"position2d"},
                                       {"planner", {}, HowMany::kOneOrNone, "goals by the robot's odometry"}};
constexpr DeviceText kVfhUses[] = {
    {"position2d", {}, HowMany::kOne, "the robot"},
    {"laser", {}, HowMany::kOneOfThese, "on the robot"},
    {"ranger", {}, HowMany::kOneOfThese, "on the robot"},
    {"sonar", {}, HowMany::kOneOfThese, "on the robot"},
};

}  // namespace

constinit const DriverDefinition kVfhDriver{
    .name = "vfh",
    .doc =
        "Drives a robot to goals and around obstacles that its laser, ranger or sonars detect: Vector Field "
        "Histogram Plus.",
    .provides = kVfhProvides,
    .uses = kVfhUses,
    .properties = kRefusalProperties,
    .read_options = reading<vfh_options>,
    .make = make_vfh,
};

Result<VfhOptions> vfh_options(SectionFields fields) {
  VfhOptions options;
  options.cell_size = fields.length(
      {"cell_size", "Cell size of the histogram grid around the robot, which uses readings up to 3 m."},
      options.cell_size, 0.005);
  options.window =
      fields.integer({"window_diameter", "Cells along a side of the grid."}, options.window, 3, 1001);
  const int sector_angle =
      fields.integer({"sector_angle", "Angular resolution, always in whole degrees; divides 360.", "deg"},
                     360 / options.sectors, 1, 90);
  fields.expect(sector_angle > 0 && 360 % sector_angle == 0, "sector_angle", "divides 360");
  options.sectors = sector_angle > 0 ? 360 / sector_angle : 0;

  const double safety = fields.length({"safety_dist_0ms",
                                       "Clearance beyond the robot's radius, which is half its length or "
                                       "width, whichever is larger: at rest."},
                                      options.safety_distance.at_rest, 0);
  options.safety_distance = {
      safety,
      fields.length(
          {"safety_dist_1ms", "The same at 1 m/s; linear in between and beyond.", {}, "safety_dist_0ms"},
          safety, 0)};
  options.max_speed = fields.length({"max_speed", "Upper limit.", "m/s"}, options.max_speed, 0);
  options.max_speed_narrow = fields.length(
      {"max_speed_narrow_opening", "Limit in openings of less than 80 degrees.", "m/s", "max_speed"},
      options.max_speed, 0);
  options.max_speed_wide = fields.length(
      {"max_speed_wide_opening", "Limit in openings of more than 80 degrees.", "m/s", "max_speed"},
      options.max_speed, 0);
  options.max_acceleration = fields.length(
      {"max_acceleration",
       "Limit, and the deceleration assumed before goals and obstacles; the robot brakes as hard as it can.",
       "m/s^2"},
      options.max_acceleration, 0.001);
  options.min_turn_rate =
      fields.angle({"min_turnrate", "When it turns on the spot.", "deg/s"}, options.min_turn_rate);
  const double turn_rate =
      fields.angle({"max_turnrate_0ms", "Upper limit at rest.", "deg/s"}, options.max_turn_rate.at_rest);
  options.max_turn_rate = {
      turn_rate, fields.angle({"max_turnrate_1ms", "Upper limit at 1 m/s; linear in between and beyond.",
                               "deg/s", "max_turnrate_0ms"},
                              turn_rate)};
  options.turn_radius_factor = fields.number({"min_turn_radius_safety_factor",
                                              "Factor on the turning radius, speed / turn rate, that decides "
                                              "whether the robot clears obstacles beside it."},
                                             options.turn_radius_factor);

  const double free_0 = fields.number({"free_space_cutoff_0ms",
                                       "A direction with a lower obstacle density is free, at rest; a larger "
                                       "value lets the robot come nearer to "
                                       "obstacles before it turns away."},
                                      options.free_cutoff.at_rest);
  const double free_1 = fields.number({"free_space_cutoff_1ms",
                                       "The same at 1 m/s; linear in between and beyond.",
                                       {},
                                       "free_space_cutoff_0ms"},
                                      free_0);
  options.free_cutoff = {free_0, free_1};
  options.blocked_cutoff = {
      fields.number(
          {"obs_cutoff_0ms",
           "A direction with a higher density is blocked, at rest; between the two cutoffs it keeps its "
           "state. Not below free_space_cutoff_0ms.",
           {},
           "free_space_cutoff_0ms"},
          free_0),
      fields.number({"obs_cutoff_1ms",
                     "The same at 1 m/s. Not below free_space_cutoff_1ms.",
                     {},
                     "free_space_cutoff_1ms"},
                    free_1)};
  fields.expect(options.blocked_cutoff.at_rest >= free_0, "obs_cutoff_0ms",
                "is not below free_space_cutoff_0ms");
  fields.expect(options.blocked_cutoff.at_1 >= free_1, "obs_cutoff_1ms",
                "is not below free_space_cutoff_1ms");
  options.weight_desired =
      fields.number({"weight_desired_dir", "Weight of the goal's direction."}, options.weight_desired);
  options.weight_current =
      fields.number({"weight_current_dir", "Weight of the previous direction."}, options.weight_current);

  options.distance_epsilon =
      fields.length({"distance_epsilon", "Tolerance of arrival."}, options.distance_epsilon, 0);
  options.angle_epsilon = fields.angle({"angle_epsilon", "Tolerance of arrival."}, options.angle_epsilon);
  options.escape_speed = fields.length(
      {"escape_speed",
       "Escape manoeuvre at a stall, if speed and time are not 0: drives without sensing at this speed.",
       "m/s"},
      options.escape_speed, SectionFields::kAnyNumber);
  options.escape_time = fields.number({"escape_time", "How long.", "s"}, options.escape_time);
  options.escape_turn_rate =
      fields.angle({"escape_max_turnrate", "Turning at this rate, left and right alternately.", "deg/s"},
                   options.escape_turn_rate);
  fields.no_effect({"synchronous", "Runs are deterministic regardless of threads."});
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace playhouse::drivers
