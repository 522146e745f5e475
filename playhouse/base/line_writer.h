#pragma once

/// LineWriter: asynchronous writer of lines to a terminal, pipe or
/// file, on its own thread, so that no caller blocks on a slow reader.
/// When the buffer is full, lines are dropped and counted in place.

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace playhouse {

class LineWriter {
 public:
  /// Buffer size.
  static constexpr std::size_t kBytes = 4u << 20;

  /// Writes to an open descriptor, which stays open: a blocked write may outlive this object.
  /// The thread is started by the first text, so that a process without output can still fork().
  explicit LineWriter(int file);
  /// Calls flush().
  ~LineWriter();
  LineWriter(const LineWriter&) = delete;
  LineWriter& operator=(const LineWriter&) = delete;

  /// Queues a whole line with its line end. Any thread; does not block.
  void add(std::string_view line);
  /// Sets the status line, shown when no line is queued; replaces the old one. Any thread; does not block.
  void show(std::string status);

  /// Waits until everything is written, up to `patience`: false on timeout.
  bool flush(std::chrono::milliseconds patience = std::chrono::seconds(1));

 private:
  struct State;
  /// Owners: this object and the thread, which cannot be joined while its write blocks.
  std::shared_ptr<State> state_;
};

}  // namespace playhouse
