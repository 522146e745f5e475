#pragma once

/// Simulation: runs one engine against the wall clock and serves its users: it carries out their requests
/// between ticks and shows those who follow the run what came of them. The only place where wall time and
/// simulated time are compared. Threads: run() is the tick thread; requests() are for all others.

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/run/follower.h"
#include "playhouse/run/history.h"
#include "playhouse/run/lock_step.h"
#include "playhouse/run/pacer.h"
#include "playhouse/run/publisher_thread.h"
#include "playhouse/run/requests.h"
#include "playhouse/world/changes/journal.h"
#include "playhouse/world/engine.h"
#include "playhouse/world/population/shares.h"

namespace playhouse::run {

class Simulation final {
 public:
  struct SimulationOptions {
    double speed = 1;  // times real time; 0: as fast as possible
    bool paused = false;
    double duration = std::numeric_limits<double>::infinity();  // simulated seconds until run() returns
    std::function<double()> clock = {};  // s; monotonic, called on the tick thread; default: the system's
    /// Sleeps until this time of `clock`; true: something was asked of the run meanwhile
    /// (Requests::is_woken). Default: the system's.
    std::function<bool(double until)> wait = {};
    std::optional<LockStep::LockStepOptions> lock_step = {};  // none: free-running
  };

  Simulation(std::unique_ptr<world::Engine> engine, SimulationOptions options);

  /// Shows the run to a follower, which must outlive run(). Before run(), or from a follower.
  void follow(Follower& follower) {
    followers_.push_back(std::shared_ptr<Follower>(std::shared_ptr<void>(), &follower));
  }
  /// The same for one that nobody else keeps.
  void follow(std::shared_ptr<Follower> follower) { followers_.push_back(std::move(follower)); }

  /// Ticks until the duration is over or somebody asks to stop, on the calling
  /// thread, the tick thread. At speed 0 without requests and without works of
  /// followers it takes no lock and involves no other thread.
  void run();
  /// Before run(), or between two calls: allows `ticks` further ticks.
  void extend(std::uint64_t ticks) { end_tick_ = engine_->world().tick() + ticks; }
  /// After the last run(): rejects pending and later requests
  /// while their callers still exist. Any thread, while run() is not running.
  void discard();

  // Any thread.
  Requests& requests() { return requests_; }
  const Requests& requests() const { return requests_; }
  /// Simulated time of the latest tick. [s]
  double time() const { return time_.load(std::memory_order_relaxed); }
  /// The barrier of a world in lock-step; null: free-running.
  LockStep* lock_step() const { return lock_step_.get(); }
  /// What each client and page brought.
  const std::shared_ptr<world::Shares>& shares() const { return shares_; }

  // Tick thread only (inside a request), or while run() is not running.
  /// Changes the world; followers see what it did with the next changes.
  world::Journal& journal() { return journal_; }
  /// Restarts: loads the initial state with another seed, as in a new run, with the
  /// initial models and ids; later models get ids never used before. Fails if the initial
  /// state was not kept: without lock-step, or with a controller that cannot be saved.
  Result<void> restart(std::uint64_t seed);
  world::Engine& engine() { return *engine_; }
  const world::World& world() const { return engine_->world(); }

 private:
  void take_requests();
  void take_pace();
  void carry_out(const Inbox::InboxEntry& entry);
  void finish_changes();
  void end_generations(const std::vector<world::ModelId>& before);
  void rewind_to(std::uint64_t tick);
  std::vector<std::byte> whole_at(std::uint64_t tick);
  void repeat(const History::Keyframe& from, std::uint64_t tick);
  void start_again_from_here();
  void publish_timeline();
  void keep_start();
  bool wait_for_tick(bool asked_for);
  void tick();
  void follow_events();
  void show();
  void finish_works();

  std::unique_ptr<world::Engine> engine_;
  std::vector<std::shared_ptr<Follower>> followers_;
  std::shared_ptr<world::Shares> shares_ = std::make_shared<world::Shares>();
  std::uint64_t end_tick_;

  // Shared between threads.
  Requests requests_;
  std::unique_ptr<LockStep> lock_step_;
  std::atomic<double> time_ = 0;

  // Tick thread.
  Requests::WantedPace now_;
  std::function<double()> clock_;
  std::function<bool(double until)> wait_;
  Pacer pacer_;
  History history_;
  std::shared_ptr<const world::Timeline> timeline_;      // as published
  std::shared_ptr<const std::vector<std::byte>> start_;  // the initial state, if kept
  std::string why_no_start_;                             // otherwise the reason
  world::Journal journal_;                               // of the changes since the last tick
  std::uint64_t settled_;                                // number of events before those changes
  std::vector<Inbox::InboxEntry> taken_;
  std::uint64_t followed_;            // number of events passed to the followers
  std::vector<Work> works_;           // for the publisher thread
  PublisherThread publisher_thread_;  // reads all of the above
};

}  // namespace playhouse::run
