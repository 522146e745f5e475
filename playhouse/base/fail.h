#pragma once

/// Error reporting of commands: one log line per finding, file position first.

#include <string>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse {

/// Exit codes of programs. Ends by a signal are 128 + its number.
enum Exit : int { kDone = 0, kFailed = 1, kUsage = 2 };

/// Returns the exit code.
int fail(const Error& error, Exit code = kFailed);

/// The same for an error in a file, with its name and line first.
int fail_at(const Error& error, Exit code = kFailed);

/// An error in a file, with `others` in the same file.
int fail_in_file(const Error& error, const std::vector<Error>& others = {});

/// A warning about a file, "file:line: text".
void warn(const std::string& line);

}  // namespace playhouse
