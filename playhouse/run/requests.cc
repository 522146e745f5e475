#include "playhouse/run/requests.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include "playhouse/base/limits.h"

namespace playhouse::run {

Requests::Requests(double speed, bool paused) {
  wanted_.speed = std::max(0.0, speed);
  wanted_.paused = paused;
}

/// False: rejected by `edit`, without effect.
template <typename Edit>
bool Requests::want(Edit edit) {
  {
    const std::lock_guard lock(mutex_);
    if constexpr (std::is_void_v<std::invoke_result_t<Edit, WantedPace&>>) {
      edit(wanted_);
    } else if (!edit(wanted_)) {
      return false;
    }
    wanted_.pace_changed = true;
    woken_.store(true);
  }
  changed_.notify_one();
  return true;
}

void Requests::stop() {
  want([](WantedPace& wanted) { wanted.stop = true; });
}

void Requests::pause() {
  want([](WantedPace& wanted) { wanted.paused = true; });
}

void Requests::resume() {
  want([](WantedPace& wanted) { wanted.paused = false; });
}

void Requests::step_once() {
  pause();
  step(1, {});
}

void Requests::step(std::uint64_t ticks, LockStep::Done done) {
  std::string why_not;
  const bool taken = want([&](WantedPace& wanted) {
    if (!wanted.paused) {
      why_not = "the world is running: pause it first, or start it with --lock-step";
    } else if (ticks > limits::kSingleSteps - wanted.steps) {
      why_not = fmt::format("too many steps are waiting: {} at most", limits::kSingleSteps);
    } else {
      wanted.steps += ticks;
      if (done) steppers_.push_back(std::move(done));
    }
    return why_not.empty();
  });
  if (!taken && done) done(why_not);
}

void Requests::set_speed(double times_real_time) {
  if (!std::isfinite(times_real_time) || times_real_time < 0) return;
  want([=](WantedPace& wanted) { wanted.speed = times_real_time; });
}

world::Pace Requests::pace() const {
  const std::lock_guard lock(mutex_);
  return {wanted_.paused, wanted_.speed, wanted_.paused ? 0 : factor_.load(std::memory_order_relaxed)};
}

void Requests::command(world::Change command) {
  inbox_.command(std::move(command));
  wake();
}

void Requests::drive(world::ModelId robot, const geom::Twist& velocity) {
  command(world::changes::Drive{robot, velocity});
}

void Requests::reserve(world::ModelId model, bool on) {
  const std::lock_guard lock(mutex_);
  if (on) {
    reserved_.insert(model);
  } else {
    reserved_.erase(model);
  }
}

bool Requests::is_reserved(world::ModelId model) const {
  const std::lock_guard lock(mutex_);
  return reserved_.contains(model);
}

bool Requests::post(Request request, world::ModelId robot) {
  if (!inbox_.post(std::move(request), robot)) return false;
  wake();
  return true;
}

bool Requests::post_to_all(Request request) {
  if (!inbox_.post_to_all(std::move(request))) return false;
  wake();
  return true;
}

void Requests::post_always(Request request, world::ModelId robot) {
  inbox_.post_always(std::move(request), robot);
  wake();
}

void Requests::record(bool on) {
  want([=](WantedPace& wanted) { wanted.recording = on; });
}

std::shared_ptr<const world::Timeline> Requests::timeline() const {
  const std::lock_guard lock(mutex_);
  return timeline_;
}

void Requests::rewind(std::uint64_t tick) {
  want([=](WantedPace& wanted) { wanted.instant = tick; });
}

std::uint64_t Requests::generation(world::ModelId model) const {
  const auto found = generations_.find(model);
  return found == generations_.end() ? 0 : found->second;
}

Requests::WantedPace Requests::take() {
  const std::lock_guard lock(mutex_);
  if (!wanted_.paused) wanted_.steps = 0;  // a running world does not need them
  WantedPace now = wanted_;
  wanted_.pace_changed = false;
  wanted_.instant.reset();
  return now;
}

void Requests::wake() {
  {
    const std::lock_guard lock(mutex_);
    woken_.store(true);
  }
  changed_.notify_one();
}

bool Requests::wait_until(std::chrono::steady_clock::time_point time) {
  std::unique_lock lock(mutex_);
  return changed_.wait_until(lock, time, [this] { return woken_.load(); });
}

/// Of those that were asked for since take(), too.
void Requests::count_step() {
  const std::lock_guard lock(mutex_);
  --wanted_.steps;
}

void Requests::answer_steps() {
  std::vector<LockStep::Done> done;
  {
    const std::lock_guard lock(mutex_);
    if (wanted_.steps == 0) done.swap(steppers_);  // else more came meanwhile, and all wait for the last
  }
  for (const LockStep::Done& each : done) each({});
}

void Requests::set_timeline(std::shared_ptr<const world::Timeline> timeline) {
  const std::lock_guard lock(mutex_);
  timeline_ = std::move(timeline);
}

void Requests::close() {
  std::vector<LockStep::Done> steppers;
  {
    const std::lock_guard lock(mutex_);
    steppers.swap(steppers_);
  }
  for (const LockStep::Done& each : steppers) each(kEnded);
  inbox_.close();
  std::vector<Inbox::InboxEntry> rejected;
  inbox_.take(rejected);
}

}  // namespace playhouse::run
