#pragma once

/// Browser: a headless Chromium as a child process, and the pipes of its
/// DevTools protocol (--remote-debugging-pipe): NUL-terminated JSON messages. It
/// has a profile folder and a process group of its own; its output is discarded.

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/app/interrupt.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

/// The full path of the first of these names found in PATH as an executable; none if none is.
std::optional<std::string> find_program(std::span<const char* const> names);

class Browser {
 public:
  using Deadline = std::chrono::steady_clock::time_point;

  /// Signals noted by `interrupt` end every wait. It must outlive the browser.
  explicit Browser(const Interrupt& interrupt) : interrupt_(interrupt) {}
  /// Kills the process group and removes the folder.
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Starts the program; call once.
  Result<void> start(const std::string& program);

  /// Queues a message, sent during receive().
  void send(std::string_view message);
  /// The next message. Fails, with a predicate for the
  /// browser's name, if it has exited, on timeout, on a message
  /// over limits::kBrowserMessage bytes, and on a signal.
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
  pid_t child_ = 0;     // process group leader; 0: none
  int to_ = -1, from_ = -1;
  std::string outgoing_, incoming_;
  std::size_t sent_ = 0;      // of outgoing_
  std::size_t searched_ = 0;  // prefix of incoming_ without a terminator
};

}  // namespace playhouse::app
