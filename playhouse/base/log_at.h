#pragma once

/// Log lines about a position in a file, in the format of compilers: "file:line: error: what".

#include <string>
#include <utility>

#include "playhouse/base/log.h"

namespace playhouse::log {

/// See write(); kinds and limits apply.
void write_at(Level level, const std::string& place, fmt::string_view format, fmt::format_args values);

template <typename... Values>
void error_at(const std::string& place, fmt::format_string<Values...> format, Values&&... values) {
  write_at(Level::kError, place, format, fmt::make_format_args(values...));
}

}  // namespace playhouse::log
