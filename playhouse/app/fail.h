#pragma once

/// How commands that are clients end when something went wrong: one line of the log, and the exit code.

#include "playhouse/app/options.h"
#include "playhouse/base/log.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

inline int fail(const Error& error, Exit code = kFailed) {
  log::error("{}", error.line());
  return code;
}

}  // namespace playhouse::app
