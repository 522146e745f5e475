#pragma once

/// AlgorithmThread: a worker thread for a driver's computations, with a queue of steps.
/// With a simulated world a step's result is due at a fixed tick, which waits for it, so
/// that runs are reproducible under any load. Without one a step runs as soon as possible,
/// a newer step replaces one that has not begun, and results are delivered when ready.
/// In a simulation of the whole program there is no thread: a step runs on the one that calls, with the same
/// results at the same ticks.

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace playhouse::drivers {

class AlgorithmThread {
 public:
  /// Applies the result of a step: on the tick thread, or on this one if there is no tick.
  using Delivery = std::function<void()>;
  /// Runs on this thread, sequentially. `fresh`: discard state of
  /// earlier steps, as none has run since the start or since clear().
  using AlgorithmStep = std::function<Delivery(bool fresh)>;
  /// Where steps run: on this thread, or inside of ticked() once they are due, without ticks inside of post().
  enum class Steps : std::uint8_t { kOnThread, kOnCaller };

  explicit AlgorithmThread(Steps steps = Steps::kOnThread) : steps_(steps) {}
  /// Joins the thread after its current step; pending results are dropped.
  ~AlgorithmThread();
  AlgorithmThread(const AlgorithmThread&) = delete;
  AlgorithmThread& operator=(const AlgorithmThread&) = delete;

  /// Results are due `delay` ticks after the tick in which the step was posted, 0: at the end of
  /// that tick. `tick`: ticks done. Call it before the first post(), and ticked() after every tick.
  void follow_ticks(std::uint64_t tick, std::uint64_t delay);
  /// Tick `tick` is done except for due results: waits for those and delivers them
  /// in the order of posting. Tick thread; calling it twice for a tick is harmless.
  void ticked(std::uint64_t tick);

  /// Any thread. Between two ticks it counts for the next one.
  void post(AlgorithmStep step);
  /// Discards all posted steps. After it returns, no result of them
  /// is or will be delivered. Any thread, but not from a Delivery.
  void clear();

 private:
  struct PostedStep {
    std::uint64_t number = 0, due = 0;
    AlgorithmStep step;              // empty once started
    std::optional<Delivery> result;  // set when finished
  };
  using Lock = std::unique_lock<std::mutex>;
  void run();
  void run_posted(Lock& lock);
  void run_step(Lock& lock, PostedStep& job);
  PostedStep* next_to_begin();
  PostedStep* find(std::uint64_t number);
  void deliver_first(Lock& lock);

  const Steps steps_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::deque<PostedStep> jobs_;  // in the order of posting
  std::uint64_t last_number_ = 0;
  std::optional<std::uint64_t> tick_;  // last tick; none without a simulated world
  std::uint64_t delay_ = 0;
  bool fresh_ = true, running_ = false, delivering_ = false, ending_ = false;
  std::thread thread_;  // started by the first step
};

}  // namespace playhouse::drivers
