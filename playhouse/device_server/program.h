#pragma once

#include <functional>

namespace playhouse::device_server {

/// A program from its first line to its exit code, which is that of `start`: with standard streams that are open, as many
/// files as the system allows, writes to nobody and beyond limits that fail, and one line for what ends it. On any
/// thread: no memory, or no thread, is one line and exit code 1. Otherwise flushes the log before terminate(): it may
/// explain an uncaught exception.
int run_program(const std::function<int()>& start);

}  // namespace playhouse::device_server
