#include "playhouse/drivers/motion/goto.h"

#include <algorithm>
#include <cmath>

#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/refusal.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/dio.h"

namespace playhouse::drivers {

namespace {

/// From `least` at `low` to `most` at `high`, and constant outside.
double ramp(double value, double low, double high, double least, double most) {
  return least + std::clamp((value - low) / (high - low), 0.0, 1.0) * (most - least);
}

/// rad/s; that takes a robot to a heading, which is so far to the left.
double turn_rate_by(double angle) {
  const double rate = geom::radians(ramp(geom::degrees(std::fabs(angle)), 5, 20, 10, 45));
  return angle < 0 ? -rate : rate;
}

}  // namespace

GotoStep goto_step(const GotoOptions& options, const geom::Pose& X_OR, const geom::Pose& X_OG,
                   bool is_there) {
  const geom::Vec2 way = X_OG.xy() - X_OR.xy();
  const double distance = std::sqrt(geom::dot(way, way));
  if (is_there || distance <= options.distance) {
    const double turn = geom::normalize(X_OG.a - X_OR.a);
    if (std::fabs(turn) <= options.angle) return {0, 0, true};
    return {0, turn_rate_by(turn), false};
  }
  constexpr double kInPlace = geom::radians(20);  // it turns on the spot if the goal is farther aside
  const double turn = geom::normalize(geom::atan2(way.y, way.x) - X_OR.a);
  if (std::fabs(turn) > kInPlace) return {0, turn_rate_by(turn), false};
  return {ramp(distance, 0, 2, 0.1, 0.7), turn, false};
}

Goto::Goto(Shell& shell, const GotoOptions& options)
    : GoalAlgorithm(shell, 0, 0),
      options_(options),
      states_(shell.client().latest(0, wire::position2d::kDataState)) {}

void Goto::take_news(std::vector<device::Publication>& more) {
  GoalAlgorithm::take_news(more);
  const std::optional<device::Publication> state = states_.take_latest();
  if (!state || !shell_.provides(kDio)) return;
  const wire::dio::Data values{1, arrived_ ? 1u : 0u};
  more.push_back({shell_.device(kDio), wire::dio::kDataValues, state->timestamp, wire::encode(values)});
}

void Goto::take_scans() {
  std::optional<Trip> now;
  {
    const std::lock_guard lock(mutex_);
    now = trip();
  }
  if (!now) return;
  if (now->drive != drive_ || X_OG_ != now->X_OG) is_there_ = false;
  drive_ = now->drive;
  X_OG_ = now->X_OG;
  const geom::Pose X_OR = pose_of(now->state.pos);
  const geom::Vec2 way = now->X_OG.xy() - X_OR.xy();
  is_there_ = is_there_ || std::sqrt(geom::dot(way, way)) <= options_.distance;
  const GotoStep step = goto_step(options_, X_OR, now->X_OG, is_there_);
  arrived_ = step.done;
  steer(*now, step.speed, step.turn_rate, step.done ? DriveEnd::kAtGoal : DriveEnd::kNot);
}

Result<GotoOptions> goto_options(SectionFields fields) {
  GotoOptions options;
  options.distance =
      fields.length({"dist_tol", "It has arrived when it is so near to the goal."}, options.distance, 0);
  options.angle =
      fields.angle({"angle_tol", "And when its heading is so near to that of the goal."}, options.angle);
  for (const std::string_view word : {"max_dist", "debug", "reactive", "reaction_turn_vel", "reaction_time",
                                      "forward_enabled", "early_check", "send_everything"})
    fields.no_effect({word, "Accepted, as files of the original have it."});
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_goto(const config::CfgSection& section, Site& site) {
  WantedDevices wanted{.provides = {{"position2d"}}, .uses = {{"position2d"}}};
  if (names_device(section, "provides", "dio")) wanted.provides.push_back({"dio"});
  return make_algorithm<Goto>(section, site, wanted, goto_options);
}

constexpr DeviceText kGotoProvides[] = {
    {"position2d"}, {"dio", {}, HowMany::kOneOrNone, "has its first bit set once the robot has arrived"}};
constexpr DeviceText kGotoUses[] = {{"position2d", {}, HowMany::kOne, "is the robot"}};

}  // namespace

constinit const DriverDefinition kGotoDriver{
    .name = "goto",
    .doc = "Drives a robot straight to goals, whatever is in the way.",
    .provides = kGotoProvides,
    .uses = kGotoUses,
    .properties = kRefusalProperties,
    .read_options = reading<goto_options>,
    .make = make_goto,
};

}  // namespace playhouse::drivers
