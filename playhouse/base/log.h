#pragma once

/// Log lines to standard error, through spdlog. Standard output belongs to results.
/// Use log::info / warn / error / debug with fmt strings; any thread.

#include <spdlog/spdlog.h>

namespace playhouse::log {

/// Sends every log line to standard error. Call once from main(), before the first line.
/// `level` is 0 errors and warnings, 1 information (the default), 2 and more diagnostics (Player's -d).
void open(int level);

using spdlog::debug;
using spdlog::error;
using spdlog::info;
using spdlog::warn;

}  // namespace playhouse::log
