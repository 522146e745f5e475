#include "playhouse/device_server/program.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "playhouse/base/fail.h"
#include "playhouse/base/log_output.h"
#include "playhouse/device_server/descriptor_limit.h"
#include "playhouse/device_server/standard_streams.h"

namespace playhouse::device_server {
namespace {

/// Writes the line at once, without allocating, and ends: nothing can be undone without memory.
[[noreturn]] void end_with(std::string_view line) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line.data(), line.size());
  _exit(kFailed);
}

std::string what_is_wrong(const std::exception& error) {
  const auto* const of_system = dynamic_cast<const std::system_error*>(&error);
  const bool is_thread = of_system && of_system->code() == std::errc::resource_unavailable_try_again;
  return (is_thread ? "out of threads or memory: " : "") + std::string(error.what());
}

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

}  // namespace

int run_program(const std::function<int()>& start) {
  keep_standard_streams();
  int code = kDone;
  try {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);  // a file beyond a limit of its size (ulimit -f) is a write that fails
    raise_descriptor_limit();
    end_in_one_line();
    code = start();
  } catch (const std::exception& error) {  // threads, standard output: nothing else throws
    if (std::ferror(stdout) == 0) return fail({{}, what_is_wrong(error)});
  }
  log::flush();  // including summaries of suppressed lines
  return finish_output(code);
}

}  // namespace playhouse::device_server
