#include "playhouse/device_server/end_in_one_line.h"

#include <unistd.h>

#include <exception>
#include <new>
#include <string_view>

#include "playhouse/base/fail.h"
#include "playhouse/base/log_output.h"

namespace playhouse::device_server {
namespace {

/// Writes the line at once, without allocating, and ends: nothing can be undone without memory.
[[noreturn]] void end_with(std::string_view line) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line.data(), line.size());
  _exit(kFailed);
}

}  // namespace

void end_in_one_line() {
  std::set_new_handler([] { end_with("error: out of memory\n"); });
  static const std::terminate_handler otherwise = std::get_terminate();
  std::set_terminate([] {
    // Threads that run end the program where another one cannot be started, before the exception is caught.
    if (!std::current_exception() && std::uncaught_exceptions() > 0)
      end_with("error: out of memory or threads\n");
    log::flush();
    otherwise();
  });
}

}  // namespace playhouse::device_server
