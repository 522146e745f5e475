#pragma once

#include <functional>
#include <string>

#include "playhouse/mesh/pipe.h"

namespace playhouse::mesh {

/// A copy of this process that does one thing, with limits of processor time and memory and nowhere to
/// print to. Thread: other threads of this process may hold locks when it is made; the copy waits for none
/// but those of memory.
class OwnProcess {
 public:
  /// Runs `work` there, with the other end of the line; pipe() is null where none can be made.
  explicit OwnProcess(const std::function<void(Pipe&)>& work);
  /// Ends it.
  ~OwnProcess();
  OwnProcess(const OwnProcess&) = delete;
  OwnProcess& operator=(const OwnProcess&) = delete;

  Pipe* pipe() { return pipe_ ? &*pipe_ : nullptr; }
  /// Ends it if it has not ended by itself, and tells how it did: "took more than 30 s", "..."; for a line that broke.
  std::string end();

 private:
  std::optional<Pipe> pipe_;
  int process_ = -1;
};

}  // namespace playhouse::mesh
