#pragma once

/// Log lines to standard error, through spdlog. Standard output belongs to results.
/// Use log::info / warn / error / debug with fmt strings; any thread.
///
/// Lines are rate-limited by kind, their level and format string (line_limits.h);
/// suppressed ones are counted, and the count is logged. The format "{}" alone, for
/// text composed elsewhere (warnings of files, the final error), is never limited.

#include <fmt/core.h>

#include <cstdint>
#include <utility>

namespace playhouse::log {

enum class Level : std::uint8_t { kDebug, kInfo, kWarn, kError };

/// Initialises logging to standard error. Call from main() before the first
/// line; again to change the level. `level` is 0 errors and warnings, 1
/// information (the default), 2 and more diagnostics (Player's -d).
void open(int level);

/// Discards all lines from now on; for fuzzers.
void silence();

void write(Level level, fmt::string_view format, fmt::format_args values);

template <typename... Values>
void debug(fmt::format_string<Values...> format, Values&&... values) {
  write(Level::kDebug, format, fmt::make_format_args(values...));
}
template <typename... Values>
void info(fmt::format_string<Values...> format, Values&&... values) {
  write(Level::kInfo, format, fmt::make_format_args(values...));
}
template <typename... Values>
void warn(fmt::format_string<Values...> format, Values&&... values) {
  write(Level::kWarn, format, fmt::make_format_args(values...));
}
template <typename... Values>
void error(fmt::format_string<Values...> format, Values&&... values) {
  write(Level::kError, format, fmt::make_format_args(values...));
}

}  // namespace playhouse::log
