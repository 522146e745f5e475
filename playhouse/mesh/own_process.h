#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "playhouse/mesh/cost.h"
#include "playhouse/mesh/pipe.h"

namespace playhouse::mesh {

/// What a child process may use: more with each file that it is given.
class Allowance {
 public:
  /// `in_use`: address space of the process before it reads. [B]
  explicit Allowance(std::size_t in_use) : in_use_(in_use) { grow(0); }
  /// False with sanitizers: their shadow memory takes address space of its own.
  static bool bounds_memory();
  /// Sets the limits of this process for so many bytes more.
  void grow(std::size_t bytes);

 private:
  std::size_t in_use_, bytes_ = 0;
};

/// A sandboxed child process (fork) with limits on CPU time and
/// memory (cost.h), and without output. Thread: other threads may hold locks
/// at the fork; the child takes no locks but the allocator's.
class OwnProcess {
 public:
  /// Runs `work` in the child with its end of the pipe; pipe() is null if the fork failed.
  explicit OwnProcess(const std::function<void(Pipe&, Allowance&)>& work);
  /// Kills the child.
  ~OwnProcess();
  OwnProcess(const OwnProcess&) = delete;
  OwnProcess& operator=(const OwnProcess&) = delete;

  Pipe* pipe() { return pipe_ ? &*pipe_ : nullptr; }
  /// Kills the child if necessary, and explains its exit: "took more than 10 s ...", "..."; for a broken
  /// pipe. `allowed`: what it could use.
  std::string end(const Cost& allowed = cost_of(0));

 private:
  std::optional<Pipe> pipe_;
  int process_ = -1;
};

}  // namespace playhouse::mesh
