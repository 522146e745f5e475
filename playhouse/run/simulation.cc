#include "playhouse/run/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::run {
namespace {

using Clock = std::chrono::steady_clock;

double wall_now() {
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

Clock::time_point wall_time(double seconds) {
  return Clock::time_point(
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
}

/// Period of show() while paused, and while the next tick is
/// far: viewers are promised a sign of life a second. [s]
constexpr double kPausedShow = 0.1, kWaitingShow = 0.25;

/// Ticks until `duration` has been simulated: the first tick at or after it.
std::uint64_t ticks_in(double duration, double interval) {
  if (!std::isfinite(duration) || duration / interval >= 1e18)
    return std::numeric_limits<std::uint64_t>::max();
  return static_cast<std::uint64_t>(std::max(0.0, std::ceil(duration / interval - 1e-9)));
}

}  // namespace

Simulation::Simulation(std::unique_ptr<world::Engine> engine, Options options)
    : engine_(std::move(engine)),
      end_tick_(ticks_in(options.duration, engine_->world().scene().interval)),
      time_(engine_->world().time()),
      clock_(options.clock ? std::move(options.clock) : wall_now),
      pacer_(engine_->world().scene().interval),
      history_(engine_->world().scene().interval, clock_),
      journal_(engine_->world()),
      settled_(engine_->world().events.end()),
      followed_(engine_->world().events.end()) {
  wanted_.speed = std::max(0.0, options.speed);
  wanted_.paused = options.paused;
  timeline_ = history_.timeline();
  if (!options.lock_step) return;
  lock_step_ = std::make_unique<LockStep>(*options.lock_step);
  lock_step_->when_changed([this] { wake(); });
  keep_start();
}

void Simulation::keep_start() {
  auto start = std::make_shared<std::vector<std::byte>>();
  const Result<void> kept = world::save_state(engine_->world(), *start);
  if (kept) {
    start_ = std::move(start);
  } else {
    why_no_start_ = kept.error().line();
  }
}

void Simulation::run() {
  const world::World& world = engine_->world();
  {
    const std::lock_guard lock(mutex_);
    pacer_.start(clock_(), wanted_.speed, wanted_.paused);
  }
  bool has_ticked = false;
  for (;;) {
    // Checked first: what members sent before requesting the tick is then in the inbox.
    const bool asked_for = lock_step_ == nullptr || lock_step_->is_due();
    // Requests after the last tick arrive before the end or after it: they never apply.
    const bool is_over = lock_step_ != nullptr && has_ticked && world.tick() >= end_tick_;
    if (!is_over && woken_.exchange(false)) {
      finish_publishing();
      take_wanted();
      take_inbox();
      if (now_.instant) rewind_to(*std::exchange(now_.instant, std::nullopt));
    }
    const bool ends = is_over || now_.stop || world.tick() >= end_tick_;
    if (!ends && !wait_for_tick(asked_for)) continue;
    if (publisher_thread_.under_way()) {
      finish_publishing();
      continue;  // drivers may have posted in reaction to this tick's data
    }
    if (ends) return;
    tick();
    has_ticked = true;
  }
}

/// True if a tick is due; otherwise waits for that, a wake-up, or the next show().
bool Simulation::wait_for_tick(bool asked_for) {
  const bool stands = !asked_for || (now_.paused && now_.steps == 0);
  const double now = clock_();
  const double due = stands ? now + kPausedShow : now_.steps > 0 ? now : pacer_.due().value_or(now);
  if (due <= now) return true;
  const double until = std::min(due, now + kWaitingShow);
  publisher_thread_.go_on();
  bool woken = false;
  {
    std::unique_lock lock(mutex_);
    woken = changed_.wait_until(lock, wall_time(until), [this] { return woken_.load(); });
  }
  if (!woken && (stands || until < due)) {
    finish_publishing();
    show();
  }
  if (lock_step_) lock_step_->look_for_silence(clock_(), now_.paused && now_.steps == 0);
  return false;
}

void Simulation::tick() {
  history_.drop_after(engine_->world().tick());
  engine_->step();
  std::vector<LockStep::Done> done;
  if (lock_step_) done = lock_step_->ticked();
  const bool last_step = now_.steps == 1;
  if (now_.steps > 0) count_step();
  pacer_.ticked(clock_());
  factor_.store(pacer_.real_time_factor(), std::memory_order_relaxed);

  const world::World& world = engine_->world();
  time_.store(world.time(), std::memory_order_relaxed);
  follow_changes();
  for (world::RunListener* const listener : run_listeners_) listener->ticked(world);
  if (now_.recording) history_.record(world);
  publish_timeline();
  encode();
  show();
  if (!done.empty() || last_step) finish_publishing();
  for (const LockStep::Done& each : done) each({});
  if (last_step) answer_steps();
}

/// Also in wanted_, which includes later requests.
void Simulation::count_step() {
  --now_.steps;
  const std::lock_guard lock(mutex_);
  --wanted_.steps;
}

void Simulation::answer_steps() {
  std::vector<LockStep::Done> done;
  {
    const std::lock_guard lock(mutex_);
    if (wanted_.steps == 0) done.swap(steppers_);  // else more came meanwhile, and all wait for the last
  }
  for (const LockStep::Done& each : done) each({});
}

/// A few messages are encoded at once; many are queued for the publisher thread.
void Simulation::encode() {
  const std::size_t ranges = sources_.ranges();
  const auto encode_range = [this](std::size_t range) { sources_.emit_range(engine_->world(), range); };
  if (ranges > 1) {
    works_.push_back({ranges, encode_range, [this] { publish(); }});
    return;
  }
  if (ranges == 1) encode_range(0);
  publish();
}

void Simulation::publish() {
  batch_.clear();
  sources_.join(batch_);
  if (!batch_.empty() && publisher_) publisher_->publish(std::exchange(batch_, {}));
}

void Simulation::follow_changes() {
  const world::World& world = engine_->world();
  for (const world::Event& event : world.events.since(followed_))
    for (const Follower& follower : followers_) follower(world, event);
  followed_ = world.events.end();
}

/// Passes the present world to watchers and listeners; starts the queued works.
void Simulation::show() {
  shown_pace_ = {now_.paused, now_.speed, now_.paused ? 0 : pacer_.real_time_factor()};
  for (const Watcher& watcher : watchers_) {
    if (!watcher.wants()) continue;
    works_.push_back({.run = [this, &watcher](std::size_t) { watcher.look(engine_->world(), shown_pace_); }});
  }
  if (!works_.empty()) publisher_thread_.begin(works_);
  if (listeners_.empty()) return;
  finish_publishing();
  for (const Listener& listener : listeners_) listener(engine_->world(), shown_pace_);
}

/// Before anything changes the world, or is sent other than a tick's data.
void Simulation::finish_publishing() {
  publisher_thread_.finish(engine_->workers());
  works_.clear();
}

void Simulation::take_wanted() {
  {
    const std::lock_guard lock(mutex_);
    if (!wanted_.paused) wanted_.steps = 0;  // a running world does not need them
    now_ = wanted_;
    wanted_.pace_changed = false;
    wanted_.instant.reset();
  }
  if (now_.recording && history_.empty()) history_.record(engine_->world());
  publish_timeline();
  if (now_.steps == 0) answer_steps();  // the world was resumed
  if (!now_.pace_changed) return;
  pacer_.change(clock_(), now_.speed, now_.paused);
  show();
}

void Simulation::take_inbox() {
  inbox_.take(taken_);
  if (taken_.empty()) return;
  finish_publishing();
  for (const Inbox::Entry& entry : taken_) {
    carry_out(entry);
    follow_changes();
  }
  taken_.clear();
  finish_changes();
  show();
}

void Simulation::carry_out(const Inbox::Entry& entry) {
  if (const auto* const request = std::get_if<Request>(&entry)) return (*request)(journal_);
  journal_.apply(std::get<world::Change>(entry));  // no effect: its model is gone
}

/// Starts controllers of models that came, so that the state is complete when saved, and shows the journal.
void Simulation::finish_changes() {
  const world::World& world = engine_->world();
  const auto moves_rows = [](const world::Event& event) {
    return event.kind != world::Event::Kind::kPlace && event.kind != world::Event::Kind::kSet;
  };
  if (!world.deciders.empty() && std::ranges::any_of(world.events.since(settled_), moves_rows))
    journal_.apply(world::changes::StartControllers{});
  settled_ = world.events.end();
  for (world::RunListener* const listener : run_listeners_) listener->changed(world, journal_.entries());
  journal_.clear();
}

/// Ends subscriptions of models that the loaded state removed or re-created;
/// within a tick, ids are assigned as if there had been no rewind.
void Simulation::end_generations(const std::vector<world::ModelId>& before) {
  std::vector<world::ModelId> others;
  std::ranges::set_symmetric_difference(before, engine_->world().models.id, std::back_inserter(others));
  for (const world::ModelId model : others) ++generations_[model];
}

void Simulation::rewind_to(std::uint64_t tick) {
  const world::World& world = engine_->world();
  if (history_.empty()) return;
  finish_publishing();
  history_.take(world);  // so that this state can be returned to
  const std::vector<world::ModelId> before = world.models.id;
  load(tick);
  if (publisher_ != nullptr) publisher_->forget();
  end_generations(before);
  time_.store(world.time(), std::memory_order_relaxed);
  pacer_.start(clock_(), now_.speed, now_.paused);
  publish_timeline();
  follow_changes();
  finish_changes();
  show();
}

/// If a controller rejects its state, the world stays, and the controller is not called any more.
void Simulation::load(std::uint64_t tick) {
  const world::World& world = engine_->world();
  const std::uint64_t now = world.tick(), seed = world.seed();
  const Result<void> loaded = journal_.load(history_.nearest(tick), seed);
  if (loaded) return;
  log::error("the run cannot be taken back: the state {}", loaded.error().text);
  if (!journal_.load(history_.nearest(now), seed))
    log::error("its controllers go on with what they remember");
  history_.give_up("the state " + loaded.error().text);
}

/// Publishes the list of keyframes to other threads.
void Simulation::publish_timeline() {
  std::shared_ptr<const world::Timeline> timeline = history_.timeline();
  if (timeline == timeline_) return;  // written by this thread only
  const std::lock_guard lock(mutex_);
  timeline_ = std::move(timeline);
}

void Simulation::wake() {
  {
    const std::lock_guard lock(mutex_);
    woken_.store(true);
  }
  changed_.notify_one();
}

/// False: rejected by `edit`, without effect.
template <typename Edit>
bool Simulation::want(Edit edit) {
  {
    const std::lock_guard lock(mutex_);
    if constexpr (std::is_void_v<std::invoke_result_t<Edit, Wanted&>>) {
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

Result<void> Simulation::restart(std::uint64_t seed) {
  if (start_ == nullptr)
    return Error{{}, why_no_start_.empty() ? "only a run with --lock-step keeps its start" : why_no_start_};
  const world::World& world = engine_->world();
  const std::vector<world::ModelId> before = world.models.id;
  if (const Result<void> loaded = journal_.load(start_, seed); !loaded) return loaded;
  if (publisher_ != nullptr) publisher_->forget();
  end_generations(before);
  history_.clear();
  time_.store(world.time(), std::memory_order_relaxed);
  pacer_.start(clock_(), now_.speed, now_.paused);
  publish_timeline();
  return {};
}

void Simulation::discard() {
  if (lock_step_) lock_step_->close(kEnded);
  std::vector<LockStep::Done> steppers;
  {
    const std::lock_guard lock(mutex_);
    steppers.swap(steppers_);
  }
  for (const LockStep::Done& each : steppers) each(kEnded);
  inbox_.close();
  inbox_.take(taken_);
  taken_.clear();
}

void Simulation::stop() {
  want([](Wanted& wanted) { wanted.stop = true; });
}

void Simulation::pause() {
  want([](Wanted& wanted) { wanted.paused = true; });
}

void Simulation::resume() {
  want([](Wanted& wanted) { wanted.paused = false; });
}

void Simulation::step_once() {
  pause();
  step(1, {});
}

void Simulation::step(std::uint64_t ticks, LockStep::Done done) {
  std::string why_not;
  const bool taken = want([&](Wanted& wanted) {
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

void Simulation::set_speed(double times_real_time) {
  if (!std::isfinite(times_real_time) || times_real_time < 0) return;
  want([=](Wanted& wanted) { wanted.speed = times_real_time; });
}

void Simulation::drive(world::ModelId robot, const geom::Twist& velocity) {
  command({robot, wire::position2d::kCode}, world::changes::Drive{robot, velocity});
}

void Simulation::reserve(world::ModelId model, bool on) {
  const std::lock_guard lock(mutex_);
  if (on) {
    reserved_.insert(model);
  } else {
    reserved_.erase(model);
  }
}

bool Simulation::is_reserved(world::ModelId model) const {
  const std::lock_guard lock(mutex_);
  return reserved_.contains(model);
}

bool Simulation::post(Request request, world::ModelId robot) {
  if (!inbox_.post(std::move(request), robot)) return false;
  wake();
  return true;
}

bool Simulation::post_to_all(Request request) {
  if (!inbox_.post_to_all(std::move(request))) return false;
  wake();
  return true;
}

void Simulation::post_always(Request request, world::ModelId robot) {
  inbox_.post_always(std::move(request), robot);
  wake();
}

void Simulation::record(bool on) {
  want([=](Wanted& wanted) { wanted.recording = on; });
}

std::shared_ptr<const world::Timeline> Simulation::timeline() const {
  const std::lock_guard lock(mutex_);
  return timeline_;
}

void Simulation::rewind(std::uint64_t tick) {
  want([=](Wanted& wanted) { wanted.instant = tick; });
}

std::uint64_t Simulation::generation(world::ModelId model) const {
  const auto found = generations_.find(model);
  return found == generations_.end() ? 0 : found->second;
}

void Simulation::command(Inbox::Slot slot, world::Change command) {
  inbox_.command(slot, std::move(command));
  wake();
}

world::Pace Simulation::pace() const {
  const std::lock_guard lock(mutex_);
  return {wanted_.paused, wanted_.speed, wanted_.paused ? 0 : factor_.load(std::memory_order_relaxed)};
}

}  // namespace playhouse::run
