#pragma once

#include <functional>
#include <string>

#include "playhouse/mesh/pipe.h"

namespace playhouse::mesh {

/// A sandboxed child process (fork) with limits on CPU time and
/// memory, and without output. Thread: other threads may hold locks
/// at the fork; the child takes no locks but the allocator's.
class OwnProcess {
 public:
  /// Runs `work` in the child with its end of the pipe; pipe() is null if the fork failed.
  explicit OwnProcess(const std::function<void(Pipe&)>& work);
  /// Kills the child.
  ~OwnProcess();
  OwnProcess(const OwnProcess&) = delete;
  OwnProcess& operator=(const OwnProcess&) = delete;

  Pipe* pipe() { return pipe_ ? &*pipe_ : nullptr; }
  /// Kills the child if necessary, and explains its exit: "took more than 30 s", "..."; for a broken pipe.
  std::string end();

 private:
  std::optional<Pipe> pipe_;
  int process_ = -1;
};

}  // namespace playhouse::mesh
