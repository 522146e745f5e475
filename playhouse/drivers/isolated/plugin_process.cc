#include "playhouse/drivers/isolated/plugin_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

extern "C" {
#include <sys/pidfd.h>  // of glibc 2.36 does not say so itself
}

extern char** environ;

namespace playhouse::drivers {
namespace {

Error error_of_system(const char* what) {
  return {"", fmt::format("{}: {}", what, std::strerror(errno))};
}

void close_if_open(int descriptor) {
  if (descriptor >= 0) ::close(descriptor);
}

std::string name_of_signal(int signal) {
  const char* const name = ::sigabbrev_np(signal);
  return name == nullptr ? fmt::format("signal {}", signal) : fmt::format("SIG{}", name);
}

/// A group of its own, so that Ctrl-C is for us, who end it in order; no signal blocked or ignored, whatever our
/// thread does.
void set_attributes(posix_spawnattr_t& attributes) {
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  ::posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
}

/// The descriptors that it has; whatever else of ours is not closed on exec is closed here.
void set_descriptors(posix_spawn_file_actions_t& actions, int socket, int output) {
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, socket, kPluginSocket);
  ::posix_spawn_file_actions_addclosefrom_np(&actions, kPluginSocket + 1);
}

}  // namespace

Result<std::unique_ptr<PluginProcess>> PluginProcess::start(const std::filesystem::path& program,
                                                            std::string name) {
  std::unique_ptr<PluginProcess> process(new PluginProcess());
  std::array<int, 2> sockets{-1, -1}, pipe{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0)
    return error_of_system("gets no sockets");
  process->socket_ = sockets[0];
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    const Error error = error_of_system("gets no pipe");
    ::close(sockets[1]);
    return error;
  }
  process->output_ = pipe[0];
  ::fcntl(pipe[0], F_SETFL, O_NONBLOCK);
  const Result<void> spawned = process->spawn(program, std::move(name), sockets[1], pipe[1]);
  ::close(sockets[1]);
  ::close(pipe[1]);
  if (!spawned) return spawned.error();
  return process;
}

/// posix_spawn, for there are other threads: nothing of ours runs between fork and exec.
Result<void> PluginProcess::spawn(const std::filesystem::path& program, std::string name, int socket,
                                  int output) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  set_descriptors(actions, socket, output);
  set_attributes(attributes);
  std::string self = "playhouse", word = kPluginProcessWord;
  std::array<char*, 4> words{self.data(), word.data(), name.data(), nullptr};
  errno = ::posix_spawn(&process_, program.c_str(), &actions, &attributes, words.data(), environ);
  const bool good = errno == 0;
  const Error error_of_start = error_of_system("starts no process");
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (!good) {
    process_ = -1;
    return error_of_start;
  }
  ending_ = ::pidfd_open(process_, 0);
  if (ending_ >= 0) return {};
  const Error error_of_watching = error_of_system("cannot watch its process");
  ::kill(process_, SIGKILL);
  return error_of_watching;
}

PluginProcess::~PluginProcess() {
  if (process_ > 0 && !was_waited_for_) {
    kill();
    wait();
  }
  for (const int descriptor : {socket_, output_, ending_}) close_if_open(descriptor);
}

void PluginProcess::kill() const {
  ::pidfd_send_signal(ending_, SIGKILL, nullptr, 0);
  ::shutdown(socket_, SHUT_RDWR);  // a child of it may hold the other end
}

void PluginProcess::hang_up() const {
  ::shutdown(socket_, SHUT_WR);
}

bool PluginProcess::wait_for(siginfo_t& ended, int options) const {
  int done = -1;
  do done = ::waitid(P_PID, static_cast<id_t>(process_), &ended, options);
  while (done != 0 && errno == EINTR);
  return done == 0;
}

PluginProcess::ProcessOutcome PluginProcess::wait() {
  was_waited_for_ = true;
  siginfo_t ended{};
  if (!wait_for(ended, WEXITED | WNOWAIT)) return {false, "its process has ended"};
  ::kill(-process_, SIGKILL);  // its number is that of its group and of nobody else until it is reaped
  wait_for(ended, WEXITED);
  if (ended.si_code == CLD_EXITED)
    return {ended.si_status == 0, fmt::format("its process ended with exit code {}", ended.si_status)};
  return {false, fmt::format("its process was ended by {}", name_of_signal(ended.si_status))};
}

}  // namespace playhouse::drivers
