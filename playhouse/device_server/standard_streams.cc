#include "playhouse/device_server/standard_streams.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>

#include "playhouse/base/fail.h"

namespace playhouse::device_server {
namespace {

bool reader_left() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

}  // namespace

void keep_standard_streams() {
  int file = STDIN_FILENO;
  // Read-only: writes fail instead of being lost silently.
  while (file >= STDIN_FILENO && file <= STDERR_FILENO) file = open("/dev/null", O_RDONLY);
  if (file >= 0) close(file);
}

int finish_output(int code) {
  const bool flushed = std::fflush(stdout) == 0;
  if ((flushed && std::ferror(stdout) == 0) || reader_left()) return code;
  fail({{}, "standard output cannot be written"});
  return code == kDone ? kFailed : code;
}

}  // namespace playhouse::device_server
