#pragma once

/// LineWriter: text for a terminal, a pipe or a file, written by a thread of its own, so that nobody else
/// ever waits for whoever reads it. Lines that do not fit while the reader stalls are dropped, and counted
/// in their place.

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace playhouse {

class LineWriter {
 public:
  /// Of lines that wait for the reader.
  static constexpr std::size_t kBytes = 4u << 20;

  /// Writes to an open file, which stays open: a stalled write may outlive this object. The thread starts
  /// with the first text, so a process that has said nothing may still be copied by fork().
  explicit LineWriter(int file);
  /// As flush().
  ~LineWriter();
  LineWriter(const LineWriter&) = delete;
  LineWriter& operator=(const LineWriter&) = delete;

  /// A whole line, with its end. Any thread; does not wait.
  void add(std::string_view line);
  /// What to show once no line is waiting; a newer text takes its place. Any thread; does not wait.
  void show(std::string status);

  /// Waits until everything is written, but not for long: false if the reader stalls.
  bool flush(std::chrono::milliseconds patience = std::chrono::seconds(1));

 private:
  struct State;
  /// Two owners: this object and the thread, which nobody can join while its write stalls.
  std::shared_ptr<State> state_;
};

}  // namespace playhouse
