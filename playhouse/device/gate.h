#pragma once

/// Gate: lets threads through until it is closed, as to an object that is about to be destroyed. Any thread.

#include <atomic>
#include <thread>

namespace playhouse::device {

class Gate {
 public:
  /// Calls `call` unless the gate is closed.
  template <typename Call>
  void pass(const Call& call) {
    ++inside_;
    if (!is_closed_) call();
    --inside_;
  }
  /// For good; waits for those that are inside. Not from inside.
  void close() {
    is_closed_ = true;
    while (inside_ != 0) std::this_thread::yield();
  }

 private:
  std::atomic<bool> is_closed_ = false;
  std::atomic<int> inside_ = 0;  // threads
};

}  // namespace playhouse::device
