#pragma once

/// Log lines about a place in a file, which comes first, as editors follow it: "file:line: error: what".

#include <string>
#include <utility>

#include "playhouse/base/log.h"

namespace playhouse::log {

/// As write(), with its kinds and their limits.
void write_at(spdlog::level::level_enum level, const std::string& place, fmt::string_view format,
              fmt::format_args values);

template <typename... Values>
void error_at(const std::string& place, fmt::format_string<Values...> format, Values&&... values) {
  write_at(spdlog::level::err, place, format, fmt::make_format_args(values...));
}

}  // namespace playhouse::log
