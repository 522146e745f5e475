#pragma once

/// PluginThread: the hooks of one plug-in, one at a time, on a thread of their own. A hook that throws is the
/// last one. A thread that does not come back is left behind with what it uses, for nobody can end it.

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "playhouse/base/limits.h"

namespace playhouse::drivers {

class PluginThread {
 public:
  using Hook = std::function<void()>;
  /// In a simulation of the whole program there is no thread: post() runs the hook, or leaves it to the post()
  /// that is running one.
  enum class Hooks : std::uint8_t { kOnThread, kOnCaller };
  /// Called once, on the thread, with what a hook threw, as one line.
  using Failed = std::function<void(const std::string& why)>;

  /// `clock`: monotonic seconds, of any thread.
  PluginThread(Hooks hooks, std::function<double()> clock, Failed failed);
  ~PluginThread() { finish(); }
  PluginThread(const PluginThread&) = delete;
  PluginThread& operator=(const PluginThread&) = delete;

  /// `used` lives as long as the thread, which may be longer than this object.
  void keep(std::shared_ptr<void> used) { state_->used = std::move(used); }
  /// Any thread. False: limits::kPluginQueue hooks wait already, or it has ended; the hook is dropped.
  bool post(Hook hook) { return post(std::move(hook), limits::kPluginQueue); }
  /// Likewise, however many wait: for hooks whose number somebody else limits.
  bool post_anyway(Hook hook) { return post(std::move(hook), std::numeric_limits<std::size_t>::max()); }
  /// For how long a hook has been running. [s]
  double busy() const;
  /// Drops hooks that wait, and those that are posted from now on. Any thread.
  void end();
  /// Takes no more hooks, and waits for those that it has, for limits::kPluginEndSeconds at most. `recall`, if any,
  /// makes one that is running then come back.
  void finish(const std::function<void()>& recall = nullptr);

 private:
  struct ThreadState {
    mutable std::mutex mutex;  // guards what follows, but for `failed`, `clock` and `used`
    std::condition_variable changed;
    std::deque<Hook> waiting;
    std::optional<double> began;         // of the running hook; s
    bool ending = false, ended = false;  // no more hooks; none is left
    Failed failed;
    std::function<double()> clock;
    std::shared_ptr<void> used;
  };
  using Lock = std::unique_lock<std::mutex>;
  bool post(Hook hook, std::size_t most);
  static void run(ThreadState& state);
  static void run_first(ThreadState& state, Lock& lock);

  const Hooks hooks_;
  std::shared_ptr<ThreadState> state_;
  std::thread thread_;  // started by the first hook; under the mutex
};

}  // namespace playhouse::drivers
