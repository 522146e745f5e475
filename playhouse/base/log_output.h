#pragma once

/// Control of the log's output, for the program; modules
/// use log.h. Asynchronous (line_writer.h). Any thread.

#include <string>

#include "playhouse/base/log.h"
#include "playhouse/base/result.h"

namespace playhouse::log {

/// Also appends every log line, with its time, to a file,
/// which is created if missing. Call once, after open().
Result<void> also_to(const std::string& path);

/// Logs a finding with its position first, in the format of compilers:
/// "file:line: error: what"; without a position like any other line.
void tell(Level level, const Error& finding);

/// Prints a line without a level on standard error, in order with log lines.
void say(const std::string& line);
/// Sets the progress line below the log; "": none. For terminals.
void show_progress(const std::string& text);

/// Waits until all lines are written; false after a second without progress. Done
/// at exit too: call it before writing to standard output, or before aborting.
bool flush();

}  // namespace playhouse::log
