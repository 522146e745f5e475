#include "playhouse/mesh/own_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <utility>

#include "playhouse/base/mesh_limits.h"

namespace playhouse::mesh {
namespace {

constexpr int kPatience = 600;  // s, timeout of a message

void limit(int what, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(static_cast<__rlimit_resource>(what), &both);
}

/// Below the hard limit, so that it can be raised.
void limit_softly(int what, rlim_t most) {
  rlimit both{};
  if (::getrlimit(static_cast<__rlimit_resource>(what), &both) != 0) return;
  both.rlim_cur = std::min(most, both.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource>(what), &both);
}

/// Address space in use, inherited by the child.
std::size_t bytes_in_use() {
  unsigned long long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(file, "%llu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return static_cast<std::size_t>(pages) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Default signal actions and no handlers: those of the parent must not run in the child.
void restrict_self() {
  std::set_new_handler(nullptr);  // too little memory is a reason why the mesh cannot be read
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGINT, SIGTERM, SIGXCPU})
    ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, limits::kMeshSeconds);
}

}  // namespace

bool Allowance::bounds_memory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  return false;
#else
  return true;
#endif
#else
  return true;
#endif
}

void Allowance::grow(std::size_t bytes) {
  bytes_ += std::min(bytes, limits::kMeshFileBytes);
  const Cost cost = cost_of(bytes_);
  limit_softly(RLIMIT_CPU, cost.seconds);
  if (bounds_memory() && in_use_ > 0) limit_softly(RLIMIT_AS, in_use_ + cost.memory);
}

OwnProcess::OwnProcess(const std::function<void(Pipe&, Allowance&)>& work) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
  process_ = ::fork();
  if (process_ == 0) {
    ::close(ends[0]);
    restrict_self();
    try {
      Pipe pipe(ends[1]);
      Allowance allowance(bytes_in_use());
      work(pipe, allowance);
    } catch (const std::exception&) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  if (process_ < 0) {
    ::close(ends[0]);
  } else {
    // Timeout against deadlock: the child may block on a lock of this process at the fork.
    const timeval patience{kPatience, 0};
    ::setsockopt(ends[0], SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    pipe_.emplace(ends[0]);
  }
}

std::string OwnProcess::end(const Cost& allowed) {
  pipe_.reset();
  int status = 0;
  pid_t ended = -1;
  if (process_ > 0) ::kill(process_, SIGKILL);  // no effect if it has exited
  if (process_ > 0)
    while ((ended = ::waitpid(process_, &status, 0)) < 0 && errno == EINTR) {
    }
  process_ = -1;
  if (ended > 0 && WIFSIGNALED(status)) {
    if (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)
      return fmt::format("took more than {} s or {} MiB", allowed.seconds, allowed.memory >> 20);
    return fmt::format("ended its process by signal {}", WTERMSIG(status));
  }
  return "took too much memory";
}

OwnProcess::~OwnProcess() {
  if (process_ <= 0) return;
  end();
}

}  // namespace playhouse::mesh
