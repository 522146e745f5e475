#include "playhouse/drivers/wavefront/wavefront_options.h"

#include <fmt/format.h>

#include "playhouse/drivers/refusal.h"
#include "playhouse/drivers/wavefront/wavefront.h"

namespace playhouse::drivers {
namespace {

constexpr DeviceText kWavefrontProvides[] = {{"planner"}};
constexpr DeviceText kWavefrontUses[] = {
    {"position2d", "output", HowMany::kOne, "goes to poses, best one that avoids obstacles, as of nd or vfh"},
    {"position2d", "input", HowMany::kOne, "its STATE is the robot's pose on the map; may be the output"},
    {"map"},
    {"laser", {}, HowMany::kOneOfTheseOrNone, "on the robot, for what is not on the map"},
    {"ranger", {}, HowMany::kOneOfTheseOrNone, "the same"},
    {"sonar", {}, HowMany::kOneOfTheseOrNone, "the same"},
};

}  // namespace

constinit const DriverDefinition kWavefrontDriver{
    .name = "wavefront",
    .doc =
        "Plans a path to a goal on a grid map, round what its laser, ranger or sonars see besides, and "
        "drives a "
        "robot along it.",
    .provides = kWavefrontProvides,
    .uses = kWavefrontUses,
    .properties = kRefusalProperties,
    .read_options = reading<wavefront_options>,
    .make = make_wavefront,
};

Result<WavefrontOptions> wavefront_options(SectionFields fields) {
  WavefrontOptions options;
  PlanOptions& plan = options.plan;
  plan.safety_distance =
      fields.length({"safety_dist", "No path is nearer to an obstacle, from the robot's center of rotation."},
                    plan.safety_distance, 0);
  plan.max_radius =
      fields.length({"max_radius", "Obstacles farther away than this do not matter."}, plan.max_radius, 0);
  plan.penalty = fields.number({"dist_penalty",
                                "At safety_dist from an obstacle a path costs 1 + this times its length; 0 "
                                "for the shortest path, 1000 at most."},
                               plan.penalty);
  fields.expect(plan.penalty <= kMostPenalty, "dist_penalty", fmt::format("is {} at most", kMostPenalty));
  options.distance_epsilon =
      fields.length({"distance_epsilon", "When a waypoint is reached; more than that of the output."},
                    options.distance_epsilon, 0);
  options.angle_epsilon = fields.angle(
      {"angle_epsilon", "When its heading is reached; more than that of the output."}, options.angle_epsilon);
  options.replan_distance = fields.length({"replan_dist_thresh",
                                           "Plans anew if the robot has moved so far since the last plan, "
                                           "replan_min_time ago; 0 or less: never."},
                                          options.replan_distance, SectionFields::kAnyNumber);
  options.replan_time = fields.number({"replan_min_time", "See replan_dist_thresh; 0 or less: never.", "s"},
                                      options.replan_time, SectionFields::kAnyNumber);
  options.turns = fields.flag({"add_rotational_waypoints",
                               "Turns on the spot where the path's heading changes by more than 45 degrees, "
                               "and likewise at the start, with a "
                               "waypoint of its own there."},
                              options.turns);
  options.refresh_map = fields.flag(
      {"force_map_refresh", "1: reads the map for each goal, instead of when the device is opened."},
      options.refresh_map);
  SeenOptions& sight = options.sight;
  sight.lasts = fields.number({"obstacle_time",
                               "How long something that is not on the map is remembered while the laser, "
                               "ranger or sonars do not see its "
                               "place; twice as long each time that it is found there again, up to 32 times.",
                               "s"},
                              sight.lasts);
  sight.range = fields.length(
      {"obstacle_range",
       "What they see farther away than this is no obstacle yet; less than the range of sonars."},
      sight.range, 0);
  sight.tolerance = fields.length(
      {"obstacle_tolerance",
       "What they see so near to an obstacle of the map is that obstacle; more than the error of the "
       "robot's pose."},
      sight.tolerance, 0);
  fields.no_effect({"request_map", "The map is always requested."});
  fields.no_effect({"cspace_file", "The costs of a map take less time than to read them."});
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace playhouse::drivers
