#pragma once

/// PublisherThread: runs read-only work on the world between two ticks in parallel
/// to the tick thread: encoding of messages, copies for viewers. The tick thread
/// goes on to wait for its next tick; before anything changes the world it calls
/// finish(), takes over what has not started and waits for the rest. So no copy of
/// the world is needed, at most one tick's work is in progress, and all output of
/// a tick precedes the next change. Thread: tick, unless stated otherwise.

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "playhouse/world/workers.h"

namespace playhouse::run {

/// Parts 0 to parts - 1, each run once, on any thread, in parallel. After the
/// last one `end`, if set, is called once, on the thread that finished it.
struct Work {
  std::size_t parts = 1;
  std::function<void(std::size_t part)> run;
  std::function<void()> end = {};
};

class PublisherThread {
 public:
  PublisherThread() = default;
  /// Needs that nothing is in progress.
  ~PublisherThread();
  PublisherThread(const PublisherThread&) = delete;
  PublisherThread& operator=(const PublisherThread&) = delete;

  /// Needs that nothing is in progress; `works`, at least one, must not change until finish().
  /// Many parts are shared at once; few are not worth waking a thread, unless go_on() is called.
  void begin(std::span<const Work> works);
  /// The caller is about to block: the thread continues without it.
  void go_on();
  /// Between begin() and finish().
  bool under_way() const { return under_way_; }
  /// Blocks until all is done; `workers` help with parts that have not started.
  void finish(world::Workers& workers);

 private:
  struct Progress {
    std::size_t begun = 0, done = 0;  // parts
  };
  struct WorkPart {
    const Work* work = nullptr;  // valid until all its parts are done
    Progress* progress = nullptr;
    std::size_t number = 0;
  };
  void wake();
  void run();
  void do_parts();
  std::optional<WorkPart> take();
  std::optional<WorkPart> next();  // holding the mutex
  void did(const WorkPart& part);
  bool many_left() const;

  bool under_way_ = false, awake_ = false;

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable begun_, ended_;
  std::span<const Work> works_;
  std::vector<Progress> progress_;  // of each work
  std::size_t works_ended_ = 0;
  bool ending_ = false;

  std::thread thread_;  // started by the first work
};

}  // namespace playhouse::run
