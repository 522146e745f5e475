#pragma once

/// How commands say what is wrong: one line of the log per finding, a place in a file first.

#include <string>
#include <vector>

#include "playhouse/app/options.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

/// Gives the exit code.
int fail(const Error& error, Exit code = kFailed);

/// The same for an error about a file, whose name and line come first.
int fail_at(const Error& error, Exit code = kFailed);

/// A file that is wrong, with `others` that are wrong in it.
int fail_in_file(const Error& error, const std::vector<Error>& others = {});

/// A line about something odd in a file, "file:line: text".
void warn(const std::string& line);

}  // namespace playhouse::app
