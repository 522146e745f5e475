#include "playhouse/drivers/algorithm/goal_algorithm.h"

#include <utility>

#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/refusal.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

GoalAlgorithm::GoalAlgorithm(Shell& shell, std::size_t output, std::size_t input)
    : shell_(shell), output_(output), position_(shell.client().queue(input, kStatesKept)) {
  shell.on_command<p2d::CmdPos>(p2d::kCmdPos,
                                [this](const p2d::CmdPos& command) { return take_goal(command, true); });
  shell.forward_others(output, [this](const device::Message& message) { return take_other(message); });
  shell.on_refusal_asked([this] {
    const std::lock_guard lock(mutex_);
    return goal_ && !enabled_ ? std::string(kDisabled) : refusal_;
  });
}

void GoalAlgorithm::opened() {
  {
    const std::lock_guard lock(mutex_);
    incapable_.clear();
  }
  ask_geometry();
}

void GoalAlgorithm::closing() {
  if (set_goal(std::nullopt)) drive(0, 0);  // stop: the robot may stay open for others
}

void GoalAlgorithm::closed() {
  const std::lock_guard lock(mutex_);
  state_.reset();
  enabled_ = true;
}

/// The goal stays, unless the run starts again.
void GoalAlgorithm::rewound(const Moment& moment) {
  if (moment.tick == 0) set_goal(std::nullopt);
  const std::lock_guard lock(mutex_);
  state_.reset();
}

device::Taken GoalAlgorithm::take_other(const device::Message& message) {
  const bool was_driving = set_goal(std::nullopt);
  const device::Taken taken = shell_.client().command(output_, message.subtype, message.body);
  const bool is_taken = taken == device::Taken::kLatest || taken == device::Taken::kQueued;
  if (was_driving && !is_taken) drive(0, 0);  // stop: no longer controlled
  return taken;
}

device::Taken GoalAlgorithm::take_goal(const p2d::CmdPos& command, bool start) {
  if (!is_usable(command.pos)) {
    refuse(std::string(kUnusableGoal));
    return device::Taken::kNo;
  }
  set_goal(pose_of(command.pos));
  const std::lock_guard lock(mutex_);
  enabled_ = enabled_ || start;
  return incapable_.empty() ? device::Taken::kLatest : device::Taken::kNo;
}

/// The goal that it was given last; it goes on with an earlier one.
void GoalAlgorithm::refuse(std::string why) {
  bool is_news = false;
  {
    const std::lock_guard lock(mutex_);
    is_news = keep_refusal(refusal_, why);
  }
  if (is_news) log_refusal(shell_.name(), why);
}

void GoalAlgorithm::drives_to_none(std::string why) {
  log_refusal(shell_.name(), why);
  bool was_driving = false;
  {
    const std::lock_guard lock(mutex_);
    was_driving = goal_.has_value();
    if (was_driving) refusal_ = why;
    goal_.reset();
    X_OD_.reset();
    incapable_ = std::move(why);
  }
  if (was_driving) drive(0, 0);
}

/// Replaces or clears the goal; true if there was one. A drive goes on with another goal and what it knows,
/// so that goals may come at any rate; none of its commands follows its end.
bool GoalAlgorithm::set_goal(std::optional<geom::Pose> X_OG) {
  bool had_one = false;
  {
    const std::lock_guard lock(mutex_);
    had_one = goal_.has_value();
    gave_up_ = false;
    refusal_ = X_OG ? incapable_ : std::string();  // logged already
    X_OD_ = X_OG;
    done_ = false;
    if (!incapable_.empty()) X_OG.reset();
    if (X_OG && goal_) {
      goal_->X_OG = *X_OG;
      return true;
    }
    goal_.reset();
    if (X_OG) goal_ = {*X_OG, ++drives_};
  }
  shell_.drop_steps();
  return had_one;
}

void GoalAlgorithm::take_news(std::vector<device::Publication>& more) {
  for (device::Publication& message : position_.take()) {
    if (message.subtype == p2d::kDataState) take_state(message);
    const bool is_state = message.subtype == p2d::kDataState;
    const double time = message.timestamp;
    message.device = shell_.device(0);
    more.push_back(std::move(message));
    if (!is_state || !planner_ || !shell_.provides(*planner_)) continue;
    more.push_back(
        {shell_.device(*planner_), wire::planner::kDataState, time, wire::encode(planner_state())});
  }
  take_scans();
}

bool GoalAlgorithm::is_usable_state(const p2d::Data& state) const {
  return is_usable(state.pos);
}

/// Its stall is 1, whatever the robot says, once a goal was given up.
void GoalAlgorithm::take_state(device::Publication& message) {
  Result<p2d::Data> state = wire::decode<p2d::Data>(message.body);
  if (!state) return;
  const std::lock_guard lock(mutex_);
  if (is_usable_state(*state)) state_ = *state;
  if (!gave_up_) return;
  state->stall = 1;
  message.body = wire::encode(*state);
}

std::optional<GoalAlgorithm::Trip> GoalAlgorithm::trip() const {
  if (!goal_ || !state_ || !enabled_) return std::nullopt;
  return Trip{goal_->drive, goal_->X_OG, *state_};
}

void GoalAlgorithm::steer(const Trip& trip, double speed, double turn_rate, DriveEnd end) {
  std::string why;
  {
    const std::lock_guard lock(mutex_);
    if (!goal_ || goal_->drive != trip.drive || !enabled_) return;
    if (end != DriveEnd::kNot) {
      if (trip.X_OG != goal_->X_OG) return;  // it is driving to another goal by now
      goal_.reset();
      done_ = end == DriveEnd::kAtGoal;
    }
    gave_up_ = end == DriveEnd::kStuck;
    if (gave_up_) refusal_ = why = "it gave up the goal " + goal_text(trip.X_OG) + ": the robot is stuck";
  }
  if (!why.empty()) log_refusal(shell_.name(), why);
  drive(speed, turn_rate);
}

void GoalAlgorithm::drive(double speed, double turn_rate) {
  shell_.client().command(output_, p2d::kCmdVel, wire::encode(p2d::CmdVel{{speed, 0, turn_rate}, 1}));
}

}  // namespace playhouse::drivers
