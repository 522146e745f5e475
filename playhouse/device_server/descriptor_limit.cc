#include "playhouse/device_server/descriptor_limit.h"

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"

namespace playhouse::device_server {
namespace {

constexpr std::size_t kDescriptorsOfTls =
    3;                             // of a connection: to the peer, and both ends of its decrypted side
constexpr std::size_t kFiles = 8;  // what a run opens at times: recordings, saved runs, readers of meshes

constexpr std::size_t kManySessions = 4096;  // fewer are worth a line

std::size_t open_descriptors() {
  std::error_code error;
  const std::filesystem::directory_iterator open("/proc/self/fd", error);
  return error ? 0 : static_cast<std::size_t>(std::distance(begin(open), end(open)));
}

}  // namespace

void raise_descriptor_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);  // failure leaves the old limit
}

std::size_t sessions_that_fit(bool encrypted) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return limits::kSessions;
  const auto all = static_cast<std::size_t>(limit.rlim_cur);
  const std::size_t of_each = encrypted ? kDescriptorsOfTls : 1,
                    pages = std::min(limits::kHttpConnections * of_each, all / 4),
                    others = open_descriptors() + kFiles + pages;
  const std::size_t fit =
      std::clamp<std::size_t>(all > others ? (all - others) / of_each : 1, 1, limits::kSessions);
  if (fit < kManySessions)
    log::warn("{} Player clients at most: the limit on open files is {} (ulimit -n)", fit, all);
  return fit;
}

}  // namespace playhouse::device_server
