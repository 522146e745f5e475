#pragma once

/// AlgorithmThread: a thread of its own for a driver's computations, with a mailbox of steps in front of it.
/// With a simulated world a step's result is due at a stated tick and that tick waits for it, so that a run
/// is the same whatever the computer does meanwhile. Without one a step runs as soon as it can, a newer step
/// takes the place of one that has not begun, and results come when they are ready.

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
  /// What is to be done with the result of a step: on the tick thread, or on this one where there is no tick.
  using Delivery = std::function<void()>;
  /// Runs on this thread, one after another, and ends. `fresh`: no step before it counts, as none has run
  /// since the start or since clear().
  using Step = std::function<Delivery(bool fresh)>;

  AlgorithmThread() = default;
  /// Ends the thread, after the step that runs; results that wait are not delivered.
  ~AlgorithmThread();
  AlgorithmThread(const AlgorithmThread&) = delete;
  AlgorithmThread& operator=(const AlgorithmThread&) = delete;

  /// Results are due `delay` ticks after the tick in which the step was posted, 0 being that very tick; the
  /// world has done `tick` ticks. Before anything is posted; from then on ticked() tells of every tick.
  void follow_ticks(std::uint64_t tick, std::uint64_t delay);
  /// Tick number `tick` is done, but for the results that are due: waits for them and delivers them, in the
  /// order in which they were posted. Tick thread; telling of a tick twice does no harm.
  void ticked(std::uint64_t tick);

  /// Any thread. Between two ticks it counts for the next one.
  void post(Step step);
  /// Forgets what was posted. When it returns no result of it is being delivered or will be. Any thread but
  /// from inside a result.
  void clear();

 private:
  struct Job {
    std::uint64_t number = 0, due = 0;
    Step step;                       // empty once it has begun
    std::optional<Delivery> result;  // once it has ended
  };
  using Lock = std::unique_lock<std::mutex>;
  void run();
  void run_step(Lock& lock, Job& job);
  Job* next_to_begin();
  Job* find(std::uint64_t number);
  void deliver_first(Lock& lock);

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::deque<Job> jobs_;  // in the order of posting
  std::uint64_t last_number_ = 0;
  std::optional<std::uint64_t> tick_;  // the last one done; none without a simulated world
  std::uint64_t delay_ = 0;
  bool fresh_ = true, delivering_ = false, ending_ = false;
  std::thread thread_;  // from the first step on
};

}  // namespace playhouse::drivers
