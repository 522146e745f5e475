#pragma once

/// LineLimits: how many lines of each kind a log gets, so that whoever makes a program say the same thing
/// without end fills no disk. The lines that are held back are counted, and the count is told. A value
/// without a clock of its own; times are seconds of any steady clock.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace playhouse {

class LineLimits {
 public:
  static constexpr double kLines = 100;            // of a kind at once
  static constexpr double kLinesPerSecond = 1;     // and then; the others are counted
  static constexpr double kSecondsUntilTold = 10;  // how many those were

  struct Line {
    int level;
    std::string text;
    std::string place = {};  // in a file, that comes first; empty: none
  };

  /// What is to be written, in order, now that there is one more line: the line itself unless its kind has
  /// had kLines, and kLinesPerSecond since; before it, how many lines were held back,
  /// of every kind that has held some for kSecondsUntilTold.
  std::vector<Line> pass(std::string_view kind, Line line, double now);

  /// How many lines were held back and not told yet, for the end of the program.
  std::vector<Line> summaries(double now);

 private:
  struct Kind {
    double room = 0;  // lines
    double time = 0;  // at which it was counted
    std::uint64_t held = 0;
    double held_since = 0;
    std::string example;  // the newest line that was written
  };
  void tell_held(double now, double for_seconds, std::vector<Line>& out);

  std::map<std::pair<int, std::string>, Kind> kinds_;
};

}  // namespace playhouse
