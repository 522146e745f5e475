#include "playhouse/run/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/log.h"
#include "playhouse/base/monotonic.h"
#include "playhouse/base/packing.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/saving/state.h"
#include "playhouse/world/saving/whole_state.h"

namespace playhouse::run {
namespace {

using Clock = std::chrono::steady_clock;

Clock::time_point wall_time(double seconds) {
  return Clock::time_point(
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
}

/// Period of show() while paused, and while the next tick is
/// far: viewers are promised a sign of life a second. [s]
constexpr double kPausedShow = 0.1, kWaitingShow = 0.25;

/// Longest time to compute ticks once more for a rewind, while everybody waits. [s]
constexpr double kMostRepeat = 2;

/// Ticks until `duration` has been simulated: the first tick at or after it.
std::uint64_t ticks_in(double duration, double interval) {
  if (!std::isfinite(duration) || duration / interval >= 1e18)
    return std::numeric_limits<std::uint64_t>::max();
  return static_cast<std::uint64_t>(std::max(0.0, std::ceil(duration / interval - 1e-9)));
}

}  // namespace

Simulation::Simulation(std::unique_ptr<world::Engine> engine, SimulationOptions options)
    : engine_(std::move(engine)),
      end_tick_(ticks_in(options.duration, engine_->world().scene().interval)),
      requests_(options.speed, options.paused),
      time_(engine_->world().time()),
      clock_(options.clock ? std::move(options.clock) : monotonic_seconds),
      wait_(options.wait ? std::move(options.wait)
                         : [this](double until) { return requests_.wait_until(wall_time(until)); }),
      pacer_(engine_->world().scene().interval),
      history_(engine_->world().scene().interval, clock_),
      journal_(engine_->world()),
      settled_(engine_->world().events.end()),
      followed_(settled_) {
  publish_timeline();
  if (!options.lock_step) return;
  lock_step_ = std::make_unique<LockStep>(*options.lock_step);
  lock_step_->when_changed([this] { requests_.wake(); });
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
  const world::Pace pace = requests_.pace();
  pacer_.start(clock_(), pace.speed, pace.paused);
  bool has_ticked = false;
  for (;;) {
    // Checked first: what members sent before requesting the tick is then in the inbox.
    const bool asked_for = lock_step_ == nullptr || lock_step_->is_due();
    // Requests after the last tick arrive before the end or after it: they never apply.
    const bool is_over = lock_step_ != nullptr && has_ticked && world.tick() >= end_tick_;
    if (!is_over && requests_.any()) {
      finish_works();
      take_pace();
      take_requests();
      if (now_.instant) rewind_to(*std::exchange(now_.instant, std::nullopt));
    }
    const bool ends = is_over || now_.stop || world.tick() >= end_tick_;
    if (!ends && !wait_for_tick(asked_for)) continue;
    if (publisher_thread_.under_way()) {
      finish_works();
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
  const bool woken = wait_(until);
  if (!woken && (stands || until < due)) {
    finish_works();
    show();
  }
  if (lock_step_) lock_step_->look_for_silence(clock_(), now_.paused && now_.steps == 0);
  return false;
}

void Simulation::tick() {
  if (!journal_.entries().empty()) finish_changes();  // by nobody's request
  history_.continue_from(engine_->world().tick());
  engine_->step();
  std::vector<LockStep::Done> done;
  if (lock_step_) done = lock_step_->ticked();
  const bool last_step = now_.steps == 1;
  if (now_.steps > 0) {
    --now_.steps;
    requests_.count_step();
  }
  pacer_.ticked(clock_());
  requests_.set_real_time_factor(pacer_.real_time_factor());

  const world::World& world = engine_->world();
  time_.store(world.time(), std::memory_order_relaxed);
  follow_events();
  settled_ = world.events.end();
  for (std::size_t i = 0; i < followers_.size(); ++i) followers_[i]->ticked(world);
  if (now_.recording) history_.record(world);
  publish_timeline();
  show();
  if (!done.empty() || last_step) finish_works();
  for (const LockStep::Done& each : done) each({});
  if (last_step) requests_.answer_steps();
}

void Simulation::follow_events() {
  const world::World& world = engine_->world();
  for (const world::Event& event : world.events.since(followed_))
    for (std::size_t i = 0; i < followers_.size(); ++i) followers_[i]->happened(world, event);
  followed_ = world.events.end();
}

/// Starts the works of followers on the present world, and shows it to those who watch.
void Simulation::show() {
  const world::World& world = engine_->world();
  const world::Pace pace{now_.paused, now_.speed, now_.paused ? 0 : pacer_.real_time_factor()};
  bool is_watched = false;
  for (const std::shared_ptr<Follower>& follower : followers_) {
    if (std::optional<Work> work = follower->work(world, pace)) works_.push_back(*std::move(work));
    is_watched |= follower->watches();
  }
  if (!works_.empty()) publisher_thread_.begin(works_);
  if (!is_watched) return;
  finish_works();
  for (const std::shared_ptr<Follower>& follower : followers_)
    if (follower->watches()) follower->shown(world, pace);
}

/// Before anything changes the world, or is sent other than a tick's data.
void Simulation::finish_works() {
  publisher_thread_.finish(engine_->workers());
  works_.clear();
}

void Simulation::take_pace() {
  now_ = requests_.take();
  if (now_.recording && history_.empty()) history_.record(engine_->world());
  publish_timeline();
  if (now_.steps == 0) requests_.answer_steps();  // the world was resumed
  if (!now_.pace_changed) return;
  pacer_.change(clock_(), now_.speed, now_.paused);
  show();
}

void Simulation::take_requests() {
  requests_.take(taken_);
  if (taken_.empty()) return;
  finish_works();
  for (const Inbox::InboxEntry& entry : taken_) {
    carry_out(entry);
    follow_events();
  }
  taken_.clear();
  finish_changes();
  show();
}

void Simulation::carry_out(const Inbox::InboxEntry& entry) {
  if (const auto* const request = std::get_if<Request>(&entry)) return (*request)(journal_);
  journal_.apply(std::get<world::Change>(entry));  // no effect: its model is gone
}

/// Starts controllers of models that came, so that the state is complete when saved, and shows the journal.
void Simulation::finish_changes() {
  const world::World& world = engine_->world();
  const auto moves_rows = [](const world::Event& event) {
    return event.kind != world::Event::EventKind::kPlace && event.kind != world::Event::EventKind::kSet;
  };
  if (!world.deciders.empty() && std::ranges::any_of(world.events.since(settled_), moves_rows))
    journal_.apply(world::changes::StartControllers{});
  settled_ = world.events.end();
  for (const std::shared_ptr<Follower>& follower : followers_) follower->changed(world, journal_.entries());
  history_.changed(journal_.entries());
  journal_.clear();
}

/// Ends subscriptions of models that the loaded state removed or re-created;
/// within a tick, ids are assigned as if there had been no rewind.
void Simulation::end_generations(const std::vector<world::ModelId>& before) {
  std::vector<world::ModelId> others;
  std::ranges::set_symmetric_difference(before, engine_->world().models.id, std::back_inserter(others));
  for (const world::ModelId model : others) requests_.begin_generation(model);
}

void Simulation::rewind_to(std::uint64_t tick) {
  const world::World& world = engine_->world();
  if (history_.empty()) return;
  finish_works();
  history_.leave(world);
  const std::vector<std::byte> whole = whole_at(history_.nearest(tick));
  const std::span<const std::byte> state = world::state_of(whole);
  const std::vector<world::ModelId> before = world.models.id;
  const Result<void> loaded =
      journal_.load(std::make_shared<const std::vector<std::byte>>(state.begin(), state.end()), world.seed());
  PLAYHOUSE_ASSERT(loaded.ok());
  end_generations(before);
  start_again_from_here();
  follow_events();
  finish_changes();
  history_.arrive(world);
  show();
}

/// The state at a tick of the run (world/saving/whole_state.h): a keyframe, or what the changes of the run
/// make of the one before, which nobody sees, and after which the world is as before.
std::vector<std::byte> Simulation::whole_at(std::uint64_t tick) {
  const History::Keyframe from = history_.before(tick);
  std::vector<std::byte> present;
  world::World& world = engine_->world();
  if (from.tick == tick || !world::save_whole(world, present)) return *from.whole;
  const std::uint32_t listeners = std::exchange(world.utterances.listeners, 0);  // who have heard it before
  repeat(from, tick);
  std::vector<std::byte> whole;
  if (world.tick() != tick || !world::save_whole(world, whole)) whole = *from.whole;
  PLAYHOUSE_ASSERT(world::load_whole(world, present).ok());
  world.utterances.listeners = listeners;
  followed_ = settled_ = world.events.end();
  return whole;
}

/// Ends before the tick if that takes too long, or a change is not possible as it was.
void Simulation::repeat(const History::Keyframe& from, std::uint64_t tick) {
  world::World& world = engine_->world();
  PLAYHOUSE_ASSERT(world::load_whole(world, *from.whole).ok());
  const double end = clock_() + kMostRepeat;
  for (; world.tick() < tick && clock_() < end; engine_->step_alone()) {
    for (Unpacker in(history_.changes_at(world.tick())); !in.at_end();) {
      const Result<world::Change> change = world::unpack_change(in);
      if (!change || !world::apply(world, *change))
        return log::error("the ticks after {} cannot be repeated: a change is not possible now", from.tick);
    }
  }
  if (world.tick() < tick)
    log::warn("the run goes back to tick {}: from there to tick {} takes more than {} s", from.tick, tick,
              kMostRepeat);
}

/// The time is another one.
void Simulation::start_again_from_here() {
  time_.store(engine_->world().time(), std::memory_order_relaxed);
  pacer_.start(clock_(), now_.speed, now_.paused);
  publish_timeline();
}

/// Publishes the list of keyframes to other threads.
void Simulation::publish_timeline() {
  std::shared_ptr<const world::Timeline> timeline = history_.timeline();
  if (timeline == timeline_) return;
  timeline_ = timeline;
  requests_.set_timeline(std::move(timeline));
}

Result<void> Simulation::restart(std::uint64_t seed) {
  if (start_ == nullptr)
    return Error{{}, why_no_start_.empty() ? "only a run with --lock-step keeps its start" : why_no_start_};
  const std::vector<world::ModelId> before = engine_->world().models.id;
  if (const Result<void> loaded = journal_.load(start_, seed); !loaded) return loaded;
  end_generations(before);
  history_.clear();
  start_again_from_here();
  return {};
}

void Simulation::discard() {
  if (lock_step_) lock_step_->close(Requests::kEnded);
  requests_.close();
}

}  // namespace playhouse::run
