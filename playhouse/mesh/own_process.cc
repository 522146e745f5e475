#include "playhouse/mesh/own_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// Address space in use, inherited by the child.
rlim_t bytes_in_use() {
  unsigned long long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(file, "%llu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return static_cast<rlim_t>(pages) * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

constexpr bool has_shadow_memory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  return true;
#else
  return false;
#endif
#else
  return false;
#endif
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
  const rlim_t in_use = bytes_in_use();
  if (!has_shadow_memory() && in_use > 0) limit(RLIMIT_AS, in_use + limits::kMeshMemoryBytes);
}

}  // namespace

OwnProcess::OwnProcess(const std::function<void(Pipe&)>& work) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
  process_ = ::fork();
  if (process_ == 0) {
    ::close(ends[0]);
    restrict_self();
    try {
      Pipe pipe(ends[1]);
      work(pipe);
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

std::string OwnProcess::end() {
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
      return fmt::format("took more than {} s or {} MiB", limits::kMeshSeconds,
                         limits::kMeshMemoryBytes >> 20);
    return fmt::format("ended its process by signal {}", WTERMSIG(status));
  }
  return "took too much memory";
}

OwnProcess::~OwnProcess() {
  if (process_ <= 0) return;
  end();
}

}  // namespace playhouse::mesh
