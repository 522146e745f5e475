#pragma once

/// LineLimits: rate limit of log lines by kind, so that a repeated message
/// cannot fill a disk. Suppressed lines are counted, and the count is logged. A
/// value without a clock of its own; times are seconds of any monotonic clock.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace playhouse {

class LineLimits {
 public:
  static constexpr double kLines = 100;            // burst of a kind
  static constexpr double kLinesPerSecond = 1;     // sustained rate of a kind
  static constexpr double kSecondsUntilTold = 10;  // delay of the count

  struct Line {
    int level;
    std::string text;
    std::string place = {};  // position in a file, printed first; empty: none
  };

  /// The lines to write, in order, when one more line arrives: the line
  /// itself unless its kind is over the limit; before it, summaries of
  /// kinds that have suppressed lines for kSecondsUntilTold.
  std::vector<Line> pass(std::string_view kind, Line line, double now);

  /// Summaries of all suppressed lines, for the end of the program.
  std::vector<Line> summaries(double now);

 private:
  struct LineKind {
    double room = 0;  // token bucket
    double time = 0;  // of the last update
    std::uint64_t held = 0;
    double held_since = 0;
    std::string example;  // the last line written
  };
  void tell_held(double now, double for_seconds, std::vector<Line>& out);

  std::map<std::pair<int, std::string>, LineKind> kinds_;
};

}  // namespace playhouse
