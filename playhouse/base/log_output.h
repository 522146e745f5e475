#pragma once

/// What the program itself does with the output of its log; modules that have something to say use log.h.
/// Nobody waits for whoever reads it (line_writer.h). Any thread.

#include <spdlog/common.h>

#include <string>

#include "playhouse/base/result.h"

namespace playhouse::log {

/// Appends every log line, with its time, to a file as well, which is made if it does not exist. Call once,
/// after open().
Result<void> also_to(const std::string& path);

/// A log line about a file, with its place first, as editors follow it: "file:line: error: what"; without a
/// place, a log line like any other.
void tell(spdlog::level::level_enum level, const Error& finding);

/// A line of its own on standard error, without a level, between the log lines.
void say(const std::string& line);
/// The progress line, below the log lines; "": none. For terminals.
void show_progress(const std::string& text);

/// Waits until all lines are written; false if nobody reads them for a second. The end of the program does so
/// too: call it where standard output goes on, or where the program dies.
bool flush();

}  // namespace playhouse::log
