#include "playhouse/base/line_limits.h"

#include <fmt/format.h>

#include <algorithm>

#include "playhouse/base/result.h"

namespace playhouse {

std::vector<LineLimits::Line> LineLimits::pass(std::string_view kind, Line line, double now) {
  std::vector<Line> out;
  tell_held(now, kSecondsUntilTold, out);
  const auto [found, is_new] = kinds_.try_emplace({line.level, std::string(kind)});
  LineKind& of = found->second;
  of.room = is_new ? kLines : std::min(kLines, of.room + (now - of.time) * kLinesPerSecond);
  of.time = now;
  if (of.room >= 1) {
    of.room -= 1;
    of.example = Error{line.place, line.text}.line();
    out.push_back(std::move(line));
  } else if (of.held++ == 0) {
    of.held_since = now;
  }
  return out;
}

std::vector<LineLimits::Line> LineLimits::summaries(double now) {
  std::vector<Line> out;
  tell_held(now, 0, out);
  return out;
}

void LineLimits::tell_held(double now, double for_seconds, std::vector<Line>& out) {
  for (auto& [key, kind] : kinds_) {
    if (kind.held == 0 || now - kind.held_since < for_seconds) continue;
    out.push_back({key.first, fmt::format("{} more lines in the last {:.0f} s like: {}", kind.held,
                                          std::max(1.0, now - kind.held_since), kind.example)});
    kind.held = 0;
  }
}

}  // namespace playhouse
