#pragma once

/// Browser: a Chromium without a window, as a process of ours, and the two pipes of its DevTools protocol
/// (--remote-debugging-pipe): messages are JSON texts, each ended by a zero byte. It has a folder of its own
/// for what it writes, a group of its own of processes, and nobody hears what it prints.

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/app/interrupt.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

/// The first of these names that is a program in a folder of PATH, with that folder; none: none is.
std::optional<std::string> find_program(std::span<const char* const> names);

class Browser {
 public:
  using Deadline = std::chrono::steady_clock::time_point;

  /// Signals that `interrupt` notes end every wait. It outlives the browser.
  explicit Browser(const Interrupt& interrupt) : interrupt_(interrupt) {}
  /// Ends all its processes and removes its folder.
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Starts the program, once.
  Result<void> start(const std::string& program);

  /// Puts a message behind those that go out while receive() waits.
  void send(std::string_view message);
  /// The next message. Fails, with a text that goes on from the browser's name, where it has ended, where
  /// none comes before the deadline, on one of more than limits::kBrowserMessage bytes, and when a signal
  /// came.
  Result<std::string> receive(Deadline deadline);

 private:
  Result<void> make_folder();
  Result<void> spawn(const std::string& program, int reads, int writes);
  Result<void> wait(Deadline deadline);
  bool write_some();
  bool read_some();
  std::string how_it_ended();
  void end();

  const Interrupt& interrupt_;
  std::string folder_;  // empty: none
  pid_t child_ = 0;     // and its group; 0: none
  int to_ = -1, from_ = -1;
  std::string outgoing_, incoming_;
  std::size_t sent_ = 0;      // of outgoing_
  std::size_t searched_ = 0;  // of incoming_, where no message ends
};

}  // namespace playhouse::app
