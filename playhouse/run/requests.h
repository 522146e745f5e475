#pragma once

/// Requests: what other threads ask of a run: its pace, single steps, commands, changes, another
/// instant. They are carried out by the tick thread (Simulation) between two ticks.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "playhouse/run/inbox.h"
#include "playhouse/run/lock_step.h"
#include "playhouse/world/control.h"

namespace playhouse::run {

class Requests final : public world::Control {
 public:
  Requests(double speed, bool paused);

  // Any thread.

  /// Makes Simulation::run() return before the next tick.
  void stop();
  void pause() override;
  void resume() override;
  /// Pauses a running world first.
  void step_once() override;
  /// Runs so many single steps of a paused world, which stays paused. `done`, if set, is called on
  /// the tick thread when their data are published; or at once with a reason, and without effect,
  /// if the world is running, or if more than limits::kSingleSteps would be pending.
  void step(std::uint64_t ticks, LockStep::Done done);
  void set_speed(double times_real_time) override;
  world::Pace pace() const;

  /// Command to a model. Replaces one that the tick has not consumed yet.
  void command(world::Change command);
  void drive(world::ModelId robot, const geom::Twist& velocity) override;
  void reserve(world::ModelId model, bool on) override;
  bool is_reserved(world::ModelId model) const;

  bool post(Request request, world::ModelId robot = {}) override;
  bool post_to_all(Request request);
  void post_always(Request request, world::ModelId robot);
  /// True once the run is over: nothing is carried out any more.
  bool closed() const { return inbox_.closed(); }
  /// What to answer to whoever asked for what post() rejected.
  std::string_view why_not_posted() const {
    return closed() ? kEnded : std::string_view("too many requests are waiting");
  }

  void record(bool on) override;
  std::shared_ptr<const world::Timeline> timeline() const override;
  void rewind(std::uint64_t tick) override;

  // Tick thread.

  std::uint64_t generation(world::ModelId model) const override;

  /// All that is wanted of the pace.
  struct WantedPace {
    double speed = 1;
    bool paused = false;
    bool stop = false;
    bool pace_changed = true;
    std::uint64_t steps = 0;  // single steps although paused, that are not done
    bool recording = false;
    std::optional<std::uint64_t> instant;  // to rewind to
  };

  /// True once after anything was asked for.
  bool any() { return woken_.exchange(false); }
  bool is_woken() const { return woken_.load(); }
  WantedPace take();
  void take(std::vector<Inbox::InboxEntry>& out) { inbox_.take(out); }
  /// Wakes the tick thread; any thread.
  void wake();
  /// Sleeps until that time or a wake-up; true: a wake-up.
  bool wait_until(std::chrono::steady_clock::time_point time);
  /// One single step is done.
  void count_step();
  /// Calls who waits for single steps, if none are left to do.
  void answer_steps();
  void set_real_time_factor(double factor) { factor_.store(factor, std::memory_order_relaxed); }
  void set_timeline(std::shared_ptr<const world::Timeline> timeline);
  /// The model of this id is another one from now on.
  void begin_generation(world::ModelId model) { ++generations_[model]; }
  /// Rejects all that waits, and all that comes.
  void close();

  static constexpr const char* kEnded = "the run has ended";

 private:
  template <typename Edit>
  bool want(Edit edit);

  Inbox inbox_;
  // Guards wanted_, timeline_, steppers_, reserved_ and, with changed_, the sleep of the tick thread.
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> woken_ = true;  // there is something that the tick thread has not seen
  WantedPace wanted_;
  std::shared_ptr<const world::Timeline> timeline_ = std::make_shared<world::Timeline>();
  std::vector<LockStep::Done> steppers_;  // callbacks of single steps that are not done
  std::set<world::ModelId> reserved_;
  std::atomic<double> factor_ = 0;

  std::map<world::ModelId, std::uint64_t> generations_;  // of models that a rewind re-created; tick thread
};

}  // namespace playhouse::run
