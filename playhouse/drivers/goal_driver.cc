#include "playhouse/drivers/goal_driver.h"

#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/in_ticks.h"
#include "playhouse/drivers/refusal.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

GoalDriver::GoalDriver(device::Opener& opener, std::size_t devices, std::size_t output, std::size_t input)
    : client_(opener, *this, devices), output_(output), position_(client_.queue(input, kStatesKept)) {
  client_.when_news([this](std::vector<device::Publication>& more) { take_news(more); });
}

Result<void> GoalDriver::start(device::DeviceId) {
  if (const Result<void> opened = client_.open(); !opened) return opened;
  {
    const std::lock_guard lock(mutex_);
    incapable_.clear();
  }
  ask_geometry();
  return {};
}

void GoalDriver::stop(device::DeviceId) {
  if (set_goal(std::nullopt)) drive(0, 0);  // stop: the robot may stay open for others
  client_.close();
  const std::lock_guard lock(mutex_);
  state_.reset();
}

void GoalDriver::rewound(bool to_start) {
  if (to_start) set_goal(std::nullopt);
  thread().clear();
  const std::lock_guard lock(mutex_);
  state_.reset();
}

device::Taken GoalDriver::command(const device::Message& message) {
  if (!client_.is_open()) return device::Taken::kNo;  // a goal must not wait for the next client
  if (message.subtype != p2d::kCmdPos) {
    const bool was_driving = set_goal(std::nullopt);
    const device::Taken taken = client_.command(output_, message.subtype, message.body);
    const bool is_taken = taken == device::Taken::kLatest || taken == device::Taken::kQueued;
    if (was_driving && !is_taken) drive(0, 0);  // stop: no longer controlled
    return taken;
  }
  const Result<p2d::CmdPos> command = wire::decode<p2d::CmdPos>(message.body);
  if (!command) return device::Taken::kNo;
  if (!is_usable(command->pos)) {
    refuse(std::string(kUnusableGoal));
    return device::Taken::kNo;
  }
  set_goal(pose_of(command->pos));
  const std::lock_guard lock(mutex_);
  return incapable_.empty() ? device::Taken::kLatest : device::Taken::kNo;
}

/// The goal that it was given last; it goes on with an earlier one.
void GoalDriver::refuse(std::string why) {
  bool is_news = false;
  {
    const std::lock_guard lock(mutex_);
    is_news = keep_refusal(refusal_, why);
  }
  if (is_news) log_refusal(name(), why);
}

void GoalDriver::drives_to_none(std::string why) {
  log_refusal(name(), why);
  bool was_driving = false;
  {
    const std::lock_guard lock(mutex_);
    was_driving = goal_.has_value();
    if (was_driving) refusal_ = why;
    goal_.reset();
    incapable_ = std::move(why);
  }
  if (was_driving) drive(0, 0);
}

/// Replaces or clears the goal; true if there was one. A drive goes on with another goal and what it knows,
/// so that goals may come at any rate; none of its commands follows its end.
bool GoalDriver::set_goal(std::optional<geom::Pose> X_OG) {
  bool had_one = false;
  {
    const std::lock_guard lock(mutex_);
    had_one = goal_.has_value();
    gave_up_ = false;
    refusal_ = X_OG ? incapable_ : std::string();  // logged already
    if (!incapable_.empty()) X_OG.reset();
    if (X_OG && goal_) {
      goal_->X_OG = *X_OG;
      return true;
    }
    goal_.reset();
    if (X_OG) goal_ = {*X_OG, ++drives_};
  }
  thread().clear();
  return had_one;
}

void GoalDriver::request(const device::Message& message, device::Replier replier) {
  if (!asks_for_refusal(message))
    return client_.forward(output_, message.subtype, message.body, std::move(replier));
  std::string why;
  {
    const std::lock_guard lock(mutex_);
    why = refusal_;
  }
  answer_refusal(why, std::move(replier));
}

bool GoalDriver::capable(device::DeviceId, std::uint8_t type, std::uint8_t subtype) const {
  constexpr auto kCmd = static_cast<std::uint8_t>(wire::MessageType::kCmd);
  return (type == kCmd && subtype == p2d::kCmdPos) || may_ask_for_refusal(type, subtype) ||
         client_.capable(output_, type, subtype);
}

void GoalDriver::take_news(std::vector<device::Publication>& more) {
  for (device::Publication& message : position_.take()) {
    if (message.subtype == p2d::kDataState) take_state(message);
    message.device = device_;
    more.push_back(std::move(message));
  }
  take_scans();
}

bool GoalDriver::is_usable_state(const p2d::Data& state) const {
  return is_usable(state.pos);
}

/// Its stall is 1, whatever the robot says, once a goal was given up.
void GoalDriver::take_state(device::Publication& message) {
  Result<p2d::Data> state = wire::decode<p2d::Data>(message.body);
  if (!state) return;
  const std::lock_guard lock(mutex_);
  if (is_usable_state(*state)) state_ = *state;
  if (!gave_up_) return;
  state->stall = 1;
  message.body = wire::encode(*state);
}

std::optional<GoalDriver::Trip> GoalDriver::trip() const {
  if (!goal_ || !state_) return std::nullopt;
  return Trip{goal_->drive, goal_->X_OG, *state_};
}

void GoalDriver::steer(const Trip& trip, double speed, double turn_rate, End end) {
  std::string why;
  {
    const std::lock_guard lock(mutex_);
    if (!goal_ || goal_->drive != trip.drive) return;
    if (end != End::kNot) {
      if (trip.X_OG != goal_->X_OG) return;  // it is driving to another goal by now
      goal_.reset();
    }
    gave_up_ = end == End::kStuck;
    if (gave_up_) refusal_ = why = "it gave up the goal " + goal_text(trip.X_OG) + ": the robot is stuck";
  }
  if (!why.empty()) log_refusal(name(), why);
  drive(speed, turn_rate);
}

void GoalDriver::drive(double speed, double turn_rate) {
  client_.command(output_, p2d::kCmdVel, wire::encode(p2d::CmdVel{{speed, 0, turn_rate}, 1}));
}

Result<std::unique_ptr<device::Driver>> add_goal_driver(const scene::CfgSection& section, Site& site,
                                                        std::unique_ptr<GoalDriver> driver,
                                                        device::Address device,
                                                        const std::vector<device::Address>& required) {
  const Result<device::DeviceId> id = site.add_device(device, *driver);
  if (!id) return Error{section.at("provides"), id.error().text};
  driver->set_device(*id);
  const auto connected = [&site, device, robot = required.front(), &driver = *driver]() -> Result<void> {
    run_in_ticks(site, {&device, 1}, robot, driver.thread(),
                 [&driver](const world::World& world) { driver.rewound(world.tick() == 0); });
    return {};
  };
  site.add_user({driver.get(), &driver->client(), {device}, required, section.at("requires"), connected});
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
