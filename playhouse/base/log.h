#pragma once

/// Log lines to standard error, through spdlog. Standard output belongs to results.
/// Use log::info / warn / error / debug with fmt strings; any thread.
///
/// Lines of one level and one format string are one kind, and of each kind so many are written
/// (line_limits.h); the others are counted, and the count is told. "{}" alone, a text that was made elsewhere
/// (warnings of files, the error that ends the program), is no kind: such lines are all written.

#include <spdlog/spdlog.h>

#include <utility>

namespace playhouse::log {

/// Sends every log line to standard error. Call from main(), before the first line; again
/// for another level.
/// `level` is 0 errors and warnings, 1 information (the default), 2 and more diagnostics (Player's -d).
void open(int level);

void write(spdlog::level::level_enum level, fmt::string_view format, fmt::format_args values);

template <typename... Values>
void debug(fmt::format_string<Values...> format, Values&&... values) {
  write(spdlog::level::debug, format, fmt::make_format_args(values...));
}
template <typename... Values>
void info(fmt::format_string<Values...> format, Values&&... values) {
  write(spdlog::level::info, format, fmt::make_format_args(values...));
}
template <typename... Values>
void warn(fmt::format_string<Values...> format, Values&&... values) {
  write(spdlog::level::warn, format, fmt::make_format_args(values...));
}
template <typename... Values>
void error(fmt::format_string<Values...> format, Values&&... values) {
  write(spdlog::level::err, format, fmt::make_format_args(values...));
}

}  // namespace playhouse::log
