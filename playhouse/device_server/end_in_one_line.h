#pragma once

namespace playhouse::device_server {

/// On any thread: no memory, or no thread, is one line and exit code 1. Otherwise flushes the log before
/// terminate(): it may explain an uncaught exception.
void end_in_one_line();

}  // namespace playhouse::device_server
