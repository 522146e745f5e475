#pragma once

/// PublisherThread: does what only reads the world, while that stands between two ticks, beside the tick
/// thread: encoding of messages, copies for viewers. The tick thread goes on to wait for its next tick, and
/// before anything changes the world again it finishes what is under way: it takes over what nobody has begun
/// and waits for the rest. So nothing is copied for the other thread, one tick's work at most is under way,
/// and all of a tick is out before the next thing happens to the world. Thread: tick, but for what is said
/// otherwise.

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "playhouse/world/workers.h"

namespace playhouse::drivers {

class PublisherThread {
 public:
  /// Parts 0 to parts - 1, each done once, on any thread, beside others. When all are done `end`, if there is
  /// one, is called once, on the thread that did the last.
  struct Work {
    std::size_t parts = 1;
    std::function<void(std::size_t part)> run;
    std::function<void()> end = {};
  };

  PublisherThread() = default;
  /// Nothing is under way.
  ~PublisherThread();
  PublisherThread(const PublisherThread&) = delete;
  PublisherThread& operator=(const PublisherThread&) = delete;

  /// Nothing is under way, and `works`, at least one, stay as they are until finish(). Many parts are shared
  /// from now on; few are not worth waking another thread, unless the caller has time.
  void begin(std::span<const Work> works);
  /// The caller is about to wait for something else: what is under way goes on without it.
  void go_on();
  /// Begun and not finished.
  bool under_way() const { return under_way_; }
  /// Returns when all is done; `workers` help with what nobody has begun.
  void finish(world::Workers& workers);

 private:
  struct Progress {
    std::size_t begun = 0, done = 0;  // parts
  };
  struct Part {
    const Work* work = nullptr;  // which stays while one of its parts is not done
    Progress* progress = nullptr;
    std::size_t number = 0;
  };
  void wake();
  void run();
  void do_parts();
  std::optional<Part> take();
  std::optional<Part> next();  // holding the mutex
  void did(const Part& part);
  bool many_left() const;

  bool under_way_ = false, awake_ = false;

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable begun_, ended_;
  std::span<const Work> works_;
  std::vector<Progress> progress_;  // of each work
  std::size_t works_ended_ = 0;
  bool ending_ = false;

  std::thread thread_;  // from the first work on
};

}  // namespace playhouse::drivers
