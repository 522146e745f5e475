#include "playhouse/drivers/wavefront/wavefront.h"

#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/drivers/algorithm/planner_device.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/grid_map/map_reader.h"
#include "playhouse/drivers/refusal.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/drivers/wavefront/wavefront_options.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;
namespace planner = wire::planner;

namespace {

constexpr double kElsewhere = 0.1;  // m

std::optional<geom::Pose> pose_in(const device::Publication& message) {
  const Result<p2d::Data> state = wire::decode<p2d::Data>(message.body);
  if (!state || !is_usable(state->pos)) return std::nullopt;
  return pose_of(state->pos);
}

/// The interface of the device whose scans are used; none: there is none.
std::optional<ScanInterface> scans_of(const config::CfgSection& section) {
  for (const ScanInterface each : kScanInterfaces)
    if (names_device(section, "requires", name_of(each))) return each;
  return std::nullopt;
}

}  // namespace

Wavefront::Wavefront(Shell& shell, const WavefrontOptions& options, std::optional<ScanInterface> scans)
    : shell_(shell),
      options_(options),
      output_states_(shell.client().latest(kOutput, p2d::kDataState)),
      input_states_(shell.client().latest(kInput, p2d::kDataState)) {
  serve_planner(
      shell, 0,
      {.take_goal = [this](const planner::Cmd& command, bool start) { return take_command(command, start); },
       .waypoints = [this] { return waypoints(); },
       .enable = [this](bool enabled) { enable(enabled); }});
  shell.on_refusal_asked([this] { return refusal(); });
  if (scans) scans_.emplace(shell.client(), kScans, *scans);
}

void Wavefront::opened() {
  read_map_again();
  if (!scans_) return;
  scans_->ask([this](const std::string& why) {
    log::warn("driver {}: {}, so it plans by the map alone", shell_.name(), why);
  });
}

void Wavefront::read_map_again() {
  std::uint64_t reading = 0;
  {
    const std::lock_guard lock(mutex_);
    reading = ++readings_;
    reading_ = true;
  }
  read_map(shell_.client(), kMap,
           [this, reading](Result<GridMap> map) { take_map(reading, std::move(map)); });
}

void Wavefront::take_map(std::uint64_t reading, Result<GridMap> map) {
  if (!map) log::warn("driver wavefront: it has no map to plan on: {}", map.error().text);
  const std::lock_guard lock(mutex_);
  if (reading != readings_) return;  // closed, or asked for again
  reading_ = false;
  map_fault_ = map ? std::string() : map.error().text;
  map_ = map ? std::make_shared<const GridMap>(std::move(*map)) : nullptr;
}

void Wavefront::closing() {
  if (end_drive()) halt();  // the robot may stay open for others
}

void Wavefront::closed() {
  const std::lock_guard lock(mutex_);
  ++readings_;
  map_.reset();
  enabled_ = true;
  X_WR_.reset();
  X_OR_.reset();
  recent_ = {};
  has_scan_ = false;
}

/// Clears the goal; true if the robot was driving to it. No command for it follows.
bool Wavefront::end_drive() {
  bool was_driving = false;
  {
    const std::lock_guard lock(mutex_);
    was_driving = std::exchange(driving_, false);
    goal_.reset();
    unusable_.clear();
    progress_ = {};
  }
  shell_.drop_steps();
  return was_driving;
}

void Wavefront::rewound(const Moment& moment) {
  if (moment.tick == 0) end_drive();
  const std::lock_guard lock(mutex_);
  if (!progress_.done()) progress_ = {};
  X_WR_.reset();
  X_OR_.reset();
  recent_ = {};
  has_scan_ = false;
}

device::Taken Wavefront::take_command(const planner::Cmd& command, bool start) {
  if (!is_usable(command.goal)) {
    bool is_news = false;
    {
      const std::lock_guard lock(mutex_);
      is_news = keep_refusal(unusable_, std::string(kUnusableGoal));
    }
    if (is_news) log_refusal(shell_.name(), kUnusableGoal);
    return device::Taken::kNo;
  }
  set_goal(pose_of(command.goal), start);
  return device::Taken::kLatest;
}

void Wavefront::set_goal(const geom::Pose& X_WT, bool start) {
  {
    const std::lock_guard lock(mutex_);
    enabled_ = enabled_ || start;
    unusable_.clear();
    if (goal_ && goal_->X_WT == X_WT && !progress_.done() && !options_.refresh_map && !may_have_path_now())
      return;
    goal_ = {X_WT, ++goals_};
    progress_ = {};
    reading_ = reading_ || options_.refresh_map;
  }
  if (options_.refresh_map) read_map_again();
}

/// Why there is no path may depend on where the robot is. Call with the mutex held.
bool Wavefront::may_have_path_now() const {
  if (goal_->no_path.empty() || !X_WR_) return false;
  return !goal_->X_WR || geom::dot(X_WR_->xy() - goal_->X_WR->xy(), X_WR_->xy() - goal_->X_WR->xy()) >
                             kElsewhere * kElsewhere;
}

/// Stops the robot, or lets it go on with another plan, as it may have moved meanwhile.
void Wavefront::enable(bool enabled) {
  bool was_driving = false;
  {
    const std::lock_guard lock(mutex_);
    enabled_ = enabled;
    if (!enabled) was_driving = std::exchange(driving_, false);
  }
  shell_.drop_steps();
  if (was_driving) halt();
}

void Wavefront::take_news(std::vector<device::Publication>& more) {
  const std::optional<device::Publication> output = output_states_.take_latest();
  const std::optional<device::Publication> input = input_states_.take_latest();
  const std::optional<geom::Pose> X_OR = output ? pose_in(*output) : std::nullopt;
  const std::optional<geom::Pose> X_WR = input ? pose_in(*input) : std::nullopt;
  const bool is_new_scan = scans_ && scans_->take();
  bool has_scan = false;
  std::optional<FollowIn> next;
  {
    const std::lock_guard lock(mutex_);
    if (X_OR) X_OR_ = X_OR;
    has_scan_ = has_scan_ || is_new_scan;
    if (!X_WR) return;
    X_WR_ = X_WR;
    recent_.add(input->timestamp, *X_WR);
    more.push_back({shell_.device(0), planner::kDataState, input->timestamp, wire::encode(state())});
    next = next_step(input->timestamp);
    has_scan = std::exchange(has_scan_, false);
  }
  if (!next) return;
  if (has_scan) next->seen = newest_scan();
  post(std::move(*next));
}

/// From where the robot was then: a scan waits for one pose, lest it is later than all that are known.
std::optional<PlacedScan> Wavefront::newest_scan() const {
  std::optional<RangeScan> scan = scans_->scan();
  if (!scan) return std::nullopt;
  const std::lock_guard lock(mutex_);
  const std::optional<geom::Pose> X_WR = recent_.at(scans_->time());
  if (!X_WR) return std::nullopt;
  return PlacedScan{std::move(*scan), *X_WR};
}

/// None if there is nothing to do. Call with the mutex held.
std::optional<FollowIn> Wavefront::next_step(double time) const {
  if (!goal_ || !X_WR_ || !X_OR_ || reading_ || progress_.done()) return std::nullopt;
  return FollowIn{time, goal_->number, goal_->X_WT, *X_WR_, *X_OR_, enabled_, map_, map_fault_, {}};
}

void Wavefront::post(FollowIn in) {
  shell_.post([this, in = std::move(in)](bool fresh) -> AlgorithmThread::Delivery {
    if (fresh) memory_.goal = 0;  // plan again
    FollowOut out = follow_path(options_, in, memory_);
    return [this, goal = in.goal, out = std::move(out)] { take_step(goal, out); };
  });
}

/// If the goal is another one by now, the robot sets out all the same: goals may come at any rate.
void Wavefront::take_step(std::uint64_t goal, const FollowOut& out) {
  bool must_halt = false, must_go = false;
  std::uint64_t current = 0;
  std::string no_path;  // to be logged
  {
    const std::lock_guard lock(mutex_);
    if (!goal_) return;
    if (goal_->number == goal) progress_ = out;
    current = goal_->number;
    const bool is_refused = !out.fault.empty() && !out.may_pass;
    if (current == goal && !is_refused) goal_->no_path.clear();
    if (current == goal && is_refused) {
      std::string why = "no path to " + goal_text(goal_->X_WT) + ": " + out.fault;
      if (!goal_->X_WR) goal_->X_WR = X_WR_;
      if (keep_refusal(goal_->no_path, why)) no_path = std::move(why);
    }
    must_halt = goal_->number == goal && out.route == nullptr && std::exchange(driving_, false);
    must_go = out.X_OP && enabled_;
    if (must_go) driving_ = true;
    if (progress_.done()) driving_ = false;  // the output goes on to the goal itself
  }
  if (!no_path.empty()) log_refusal(shell_.name(), no_path);
  if (must_halt) halt();
  if (must_go && out.again) {
    ask_for_refusal(shell_.client(), kOutput, [this, current](const std::string& why) {
      if (!why.empty()) take_drive(current, "its output gave up: " + why);
    });
  }
  if (must_go) go_to(current, *out.X_OP, out.again);
}

/// A waypoint that is told again may be given up again: until another one is told, the reason is kept.
void Wavefront::go_to(std::uint64_t goal, const geom::Pose& X_OP, bool again) {
  const p2d::CmdPos command{pose2d(X_OP), {}, 1};
  const device::Taken taken = shell_.client().command(kOutput, p2d::kCmdPos, wire::encode(command));
  if (taken == device::Taken::kLatest || taken == device::Taken::kQueued) {
    if (!again) take_drive(goal, "");
    return;
  }
  ask_for_refusal(shell_.client(), kOutput, [this, goal](const std::string& why) {
    const std::string no_drive = "its output does not go to poses";
    take_drive(goal, why.empty() ? no_drive : no_drive + ": " + why);
  });
}

/// Whether the output goes to the goal's waypoint, and why not.
void Wavefront::take_drive(std::uint64_t goal, const std::string& no_drive) {
  {
    const std::lock_guard lock(mutex_);
    if (!goal_ || goal_->number != goal || !keep_refusal(goal_->no_drive, no_drive)) return;
  }
  log_refusal(shell_.name(), no_drive);
}

std::string Wavefront::refusal() {
  const std::lock_guard lock(mutex_);
  if (!unusable_.empty() || !goal_) return unusable_;
  if (!enabled_ && !progress_.done()) return std::string(kDisabled);
  return goal_->no_path.empty() ? goal_->no_drive : goal_->no_path;
}

void Wavefront::halt() {
  shell_.client().command(kOutput, p2d::kCmdVel, wire::encode(p2d::CmdVel{{0, 0, 0}, 1}));
}

/// Call with the mutex held.
planner::Data Wavefront::state() const {
  planner::Data data;
  data.pos = pose2d(*X_WR_);
  data.waypoint_idx = -1;
  if (goal_) data.goal = pose2d(goal_->X_WT);
  if (progress_.route == nullptr) return data;
  const std::vector<Waypoint>& waypoints = progress_.route->waypoints;
  data.valid = 1;
  data.done = progress_.done() ? 1 : 0;
  data.waypoints_count = static_cast<std::uint32_t>(waypoints.size());
  if (progress_.done()) return data;
  data.waypoint_idx = static_cast<std::int32_t>(progress_.waypoint);
  data.waypoint = pose2d(waypoints[progress_.waypoint].X_WP);
  return data;
}

planner::WaypointsReq Wavefront::waypoints() {
  const std::lock_guard lock(mutex_);
  planner::WaypointsReq answer;
  if (progress_.route == nullptr) return answer;
  answer.waypoints_distance = progress_.route->length;
  for (const Waypoint& waypoint : progress_.route->waypoints)
    answer.waypoints.push_back(pose2d(waypoint.X_WP));
  return answer;
}

Result<std::unique_ptr<device::Driver>> make_wavefront(const config::CfgSection& section, Site& site) {
  WantedDevices wanted{.provides = {{"planner"}},
                       .uses = {{"position2d", "output"}, {"position2d", "input"}, {"map"}}};
  const std::optional<ScanInterface> scans = scans_of(section);
  if (scans) wanted.uses.push_back(wanted_scan(*scans));
  return make_algorithm<Wavefront>(section, site, wanted, wavefront_options, scans);
}

}  // namespace playhouse::drivers
