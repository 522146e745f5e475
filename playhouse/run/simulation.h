#pragma once

/// Simulation: runs one engine against the wall clock and serves its users: devices
/// post commands and changes, viewers pause and drag, and each tick's data are
/// published in one batch. The only place where wall time meets simulated time.
/// Threads: run() is the tick thread; every other function states its callers.

#include <atomic>
#include <condition_variable>
#include <functional>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/device/driver.h"
#include "playhouse/run/directory.h"
#include "playhouse/run/history.h"
#include "playhouse/run/inbox.h"
#include "playhouse/run/lock_step.h"
#include "playhouse/run/pacer.h"
#include "playhouse/run/publisher_thread.h"
#include "playhouse/run/sources.h"
#include "playhouse/world/control.h"
#include "playhouse/world/engine.h"
#include "playhouse/world/population/shares.h"
#include "playhouse/world/run_listener.h"

namespace playhouse::run {

class Simulation final : public world::Control {
 public:
  struct Options {
    double speed = 1;  // times real time; 0: as fast as possible
    bool paused = false;
    double duration = std::numeric_limits<double>::infinity();  // simulated seconds until run() returns
    std::function<double()> clock = {};  // s; monotonic, called on the tick thread; default: the system's
    std::optional<LockStep::Options> lock_step = {};  // none: free-running
  };
  /// Called after every tick once its data are published, after changes between
  /// ticks, and at 10 Hz while paused; on the tick thread, synchronously.
  using Listener = std::function<void(const world::World&, const world::Pace&)>;

  /// Copies something of the world on those occasions; read-only.
  struct Watcher {
    std::function<bool()> wants;  // asked each time on the tick thread: must be cheap
    /// Any thread, calls never overlap; wants() is not called meanwhile.
    std::function<void(const world::World&, const world::Pace&)> look;
  };

  /// Called for every entry of world.events in order, on the tick thread:
  /// between any two posted changes, and before the data of a tick and the
  /// listeners, so that its decisions are the same in every run.
  using Follower = std::function<void(const world::World&, const world::Event&)>;

  Simulation(std::unique_ptr<world::Engine> engine, Options options);

  // Before run().
  void publish_to(device::Publisher& publisher) { publisher_ = &publisher; }
  void add_listener(Listener listener) { listeners_.push_back(std::move(listener)); }
  void add_watcher(Watcher watcher) { watchers_.push_back(std::move(watcher)); }
  /// From a follower too.
  void add_follower(Follower follower) { followers_.push_back(std::move(follower)); }
  /// Observes every tick and every change between ticks. Must outlive run().
  void add_run_listener(world::RunListener& listener) { run_listeners_.push_back(&listener); }
  /// Handles a client's request to save the world, on the tick thread. Default: none, requests
  /// have no effect; which file a client may write, if any, is the operator's decision.
  using Saver = std::function<void(const world::World&)>;
  void save_by(Saver saver) { saver_ = std::move(saver); }

  /// Ticks until the duration is over or stop() is called, on the calling
  /// thread, the tick thread. At speed 0 with an empty inbox and no
  /// readers or viewers it takes no lock and involves no other thread.
  void run();
  /// Makes run() return before the next tick. Any thread.
  void stop();
  /// Before run(), or between two calls: allows `ticks` further ticks.
  void extend(std::uint64_t ticks) { end_tick_ = engine_->world().tick() + ticks; }
  /// After the last run(): rejects pending and later requests
  /// while their callers still exist. Any thread, while run() is not running.
  void discard();
  bool discarded() const { return inbox_.closed(); }  // any thread
  /// What to answer to whoever asked for what post() rejected. Any thread.
  std::string_view why_not_posted() const {
    return discarded() ? kEnded : std::string_view("too many requests are waiting");
  }

  // Control; any thread.
  void pause() override;
  void resume() override;
  /// Pauses a running world first.
  void step_once() override;
  /// Runs so many single steps of a paused world, which stays paused. `done`, if set, is called on
  /// the tick thread when their data are published; or at once with a reason, and without effect,
  /// if the world is running, or if more than limits::kSingleSteps would be pending.
  void step(std::uint64_t ticks, LockStep::Done done);
  void set_speed(double times_real_time) override;
  void drive(world::ModelId robot, const geom::Twist& velocity) override;
  void reserve(world::ModelId model, bool on) override;
  bool post(Request request, world::ModelId robot = {}) override;
  void record(bool on) override;
  std::shared_ptr<const world::Timeline> timeline() const override;
  void rewind(std::uint64_t tick) override;
  std::uint64_t generation(world::ModelId model) const override;

  // For devices; any thread.
  /// Command to a model by an interface. Replaces one that the tick has not consumed yet.
  void command(Inbox::Slot slot, world::Change command);
  bool is_reserved(world::ModelId model) const;
  bool post_to_all(Request request);
  void post_always(Request request, world::ModelId robot);
  /// Simulated time of the latest tick. [s]
  double time() const { return time_.load(std::memory_order_relaxed); }
  world::Pace pace() const;
  /// The barrier of a world in lock-step; null: free-running.
  LockStep* lock_step() const { return lock_step_.get(); }
  /// Empty: clients may not save.
  const Saver& saver() const { return saver_; }

  // Tick thread only (inside a request), or while run() is not running.
  /// Changes the world while run() is not running; followers see what it did with the next changes.
  world::Journal& journal() { return journal_; }
  /// Restarts: loads the initial state with another seed, as in a new run, with the
  /// initial models and ids; later models get ids never used before. Fails if the initial
  /// state was not kept: without lock-step, or with a controller that cannot be saved.
  Result<void> restart(std::uint64_t seed);
  void add_source(std::shared_ptr<Source> source) { sources_.add(std::move(source)); }
  void remove_source(const Source& source) { sources_.remove(source); }
  std::size_t source_count() const { return sources_.size(); }
  /// The devices of each model.
  Directory& directory() { return directory_; }
  /// What each client and page brought.
  const std::shared_ptr<world::Shares>& shares() const { return shares_; }
  world::Engine& engine() { return *engine_; }
  const world::World& world() const { return engine_->world(); }

 private:
  static constexpr const char* kEnded = "the run has ended";

  /// Requests, read by the tick thread when woken.
  struct Wanted {
    double speed = 1;
    bool paused = false;
    bool stop = false;
    bool pace_changed = true;
    std::uint64_t steps = 0;  // single steps although paused; in wanted_: all that are not done
    bool recording = false;
    std::optional<std::uint64_t> instant;  // to rewind to
  };

  void wake();
  template <typename Edit>
  bool want(Edit edit);
  void take_wanted();
  void take_inbox();
  void carry_out(const Inbox::Entry& entry);
  void finish_changes();
  void end_generations(const std::vector<world::ModelId>& before);
  void rewind_to(std::uint64_t tick);
  void load(std::uint64_t tick);
  void publish_timeline();
  void keep_start();
  bool wait_for_tick(bool asked_for);
  void tick();
  void encode();
  void publish();
  void follow_changes();
  void show();
  void finish_publishing();
  void count_step();
  void answer_steps();

  std::unique_ptr<world::Engine> engine_;
  device::Publisher* publisher_ = nullptr;
  std::list<Follower> followers_;  // a follower may add one
  std::vector<Listener> listeners_;
  std::vector<Watcher> watchers_;
  Saver saver_;
  std::vector<world::RunListener*> run_listeners_;
  Directory directory_;
  std::shared_ptr<world::Shares> shares_ = std::make_shared<world::Shares>();
  std::uint64_t end_tick_;

  // Shared between threads.
  Inbox inbox_;
  // Guards wanted_, timeline_, steppers_, reserved_ and, with changed_, the sleep of the tick thread.
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> woken_ = true;  // there are requests that the tick thread has not seen
  Wanted wanted_;
  std::shared_ptr<const world::Timeline> timeline_;
  std::vector<LockStep::Done> steppers_;  // callbacks of single steps that are not done
  std::set<world::ModelId> reserved_;
  std::unique_ptr<LockStep> lock_step_;
  std::atomic<double> time_ = 0;
  std::atomic<double> factor_ = 0;

  // Tick thread.
  Wanted now_;
  std::function<double()> clock_;
  Pacer pacer_;
  History history_;
  std::map<world::ModelId, std::uint64_t> generations_;  // of models that a rewind re-created
  std::shared_ptr<const std::vector<std::byte>> start_;  // the initial state, if kept
  std::string why_no_start_;                             // otherwise the reason
  world::Journal journal_;  // of the changes since the last tick or since the followers saw them
  std::uint64_t settled_;   // number of events before the changes under way
  std::vector<Inbox::Entry> taken_;
  std::uint64_t followed_;  // number of changes passed to the followers
  Sources sources_;
  std::vector<device::Publication> batch_;
  world::Pace shown_pace_;                    // of the last show()
  std::vector<PublisherThread::Work> works_;  // for the publisher thread
  PublisherThread publisher_thread_;          // reads all of the above
};

}  // namespace playhouse::run
