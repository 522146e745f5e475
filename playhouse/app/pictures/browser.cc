#include "playhouse/app/pictures/browser.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <thread>
#include <vector>

#include "playhouse/base/limits.h"

extern char** environ;

namespace playhouse::app {
namespace {

constexpr int kReads = 3, kWrites = 4;  // descriptors used by --remote-debugging-pipe
constexpr int kAside = 10;              // our descriptors are above those of the child
// Terminating processes may still write to the folder for a moment.
constexpr int kTries = 100;
constexpr std::chrono::milliseconds kBetweenTries{20};

/// Software rendering is slower than a GPU, but works everywhere, with
/// or without a display; most other options prevent network access.
constexpr const char* kOptions[] = {"--headless",
                                    "--remote-debugging-pipe",
                                    "--no-first-run",
                                    "--disable-sync",
                                    "--disable-background-networking",
                                    "--disable-component-update",
                                    "--disable-quic",
                                    "--disable-extensions",
                                    "--no-proxy-server",
                                    "--mute-audio",
                                    "--disable-dev-shm-usage",
                                    "--force-device-scale-factor=1",
                                    "--use-gl=angle",
                                    "--use-angle=swiftshader",
                                    "--enable-unsafe-swiftshader",
                                    "--ignore-gpu-blocklist"};

bool is_program(const std::string& path) {
  struct stat about {};
  return ::stat(path.c_str(), &about) == 0 && S_ISREG(about.st_mode) && ::access(path.c_str(), X_OK) == 0;
}

std::string system_text(int error) {
  return std::strerror(error);
}

/// Our environment, with cache and configuration folders redirected.
std::vector<std::string> environment(const std::string& folder) {
  constexpr std::string_view kPlaces[] = {"TMPDIR=", "XDG_CONFIG_HOME=", "XDG_CACHE_HOME="};
  std::vector<std::string> all;
  for (const std::string_view place : kPlaces) all.push_back(std::string(place) + folder);
  for (char** each = environ; *each != nullptr; ++each) {
    const std::string_view variable = *each;
    if (std::ranges::none_of(kPlaces, [&](std::string_view place) { return variable.starts_with(place); }))
      all.emplace_back(variable);
  }
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

/// A close-on-exec pipe.
struct Pipe {
  int read = -1, write = -1;

  Result<void> open() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return Error{"", "gets no pipe: " + system_text(errno)};
    read = ::fcntl(ends[0], F_DUPFD_CLOEXEC, kAside);
    write = ::fcntl(ends[1], F_DUPFD_CLOEXEC, kAside);
    const int error = errno;
    for (const int end : ends) ::close(end);
    return read >= 0 && write >= 0 ? Result<void>() : Error{"", "gets no pipe: " + system_text(error)};
  }
};

void close_end(int& end) {
  if (end >= 0) ::close(end);
  end = -1;
}

}  // namespace

std::optional<std::string> find_program(std::span<const char* const> names) {
  const char* const path = std::getenv("PATH");
  const std::string_view folders = path == nullptr ? "" : path;
  for (const char* const name : names) {
    for (std::size_t begin = 0; begin <= folders.size();) {
      const std::size_t end = std::min(folders.find(':', begin), folders.size());
      const std::string found = fmt::format("{}/{}", folders.substr(begin, end - begin), name);
      if (end > begin && is_program(found)) return found;
      begin = end + 1;
    }
  }
  return std::nullopt;
}

Browser::~Browser() {
  end();
}

Result<void> Browser::start(const std::string& program) {
  if (const Result<void> made = make_folder(); !made) return made;
  Pipe to, from;
  const Result<void> opened = to.open();
  const Result<void> both = opened ? from.open() : opened;
  const Result<void> started = both ? spawn(program, to.read, from.write) : both;
  close_end(to.read);
  close_end(from.write);
  to_ = to.write;
  from_ = from.read;
  for (const int end : {to_, from_})
    if (end >= 0) ::fcntl(end, F_SETFL, ::fcntl(end, F_GETFL) | O_NONBLOCK);
  return started;
}

Result<void> Browser::make_folder() {
  std::error_code error;
  const std::filesystem::path place = std::filesystem::temp_directory_path(error);
  std::string name = (error ? std::filesystem::path("/tmp") : place) / "playhouse-browser-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr)
    return Error{"", fmt::format("gets no folder {}: {}", name, system_text(errno))};
  folder_ = name;
  return {};
}

Result<void> Browser::spawn(const std::string& program, int reads, int writes) {
  std::vector<std::string> words{program};
  words.insert(words.end(), std::begin(kOptions), std::end(kOptions));
  words.push_back("--user-data-dir=" + folder_ + "/profile");
  if (::geteuid() == 0) words.emplace_back("--no-sandbox");  // no sandbox as root
  words.emplace_back("about:blank");
  std::vector<std::string> variables = environment(folder_);

  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  ::posix_spawn_file_actions_adddup2(&actions, reads, kReads);
  ::posix_spawn_file_actions_adddup2(&actions, writes, kWrites);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  // A group of its own: Ctrl-C is for us, and all of it can be ended. It shall not ignore what we ignore.
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGPIPE);
  sigaddset(&signals, SIGXFSZ);
  ::posix_spawnattr_setsigdefault(&attributes, &signals);
  const int error = ::posix_spawn(&child_, program.c_str(), &actions, &attributes, pointers(words).data(),
                                  pointers(variables).data());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return {};
  child_ = 0;
  return Error{"", "does not start: " + system_text(error)};
}

void Browser::send(std::string_view message) {
  outgoing_ += message;
  outgoing_ += '\0';
}

Result<std::string> Browser::receive(Deadline deadline) {
  for (;;) {
    if (const std::size_t end = incoming_.find('\0', searched_); end != std::string::npos) {
      std::string message = incoming_.substr(0, end);
      incoming_.erase(0, end + 1);
      searched_ = 0;
      return message;
    }
    searched_ = incoming_.size();
    if (incoming_.size() > limits::kBrowserMessage) return Error{"", "sends a message without an end"};
    if (const Result<void> waited = wait(deadline); !waited) return waited.error();
  }
}

/// Waits until something was read.
Result<void> Browser::wait(Deadline deadline) {
  for (;;) {
    if (interrupt_.signal() != 0) return Error{"", "was interrupted"};
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
    if (left <= 0) return Error{"", "does not answer in time"};
    std::array<pollfd, 2> ends{{{from_, POLLIN, 0}, {outgoing_.empty() ? -1 : to_, POLLOUT, 0}}};
    const int ready = ::poll(ends.data(), ends.size(), static_cast<int>(std::min<std::int64_t>(left, 1000)));
    if (ready <= 0) continue;
    if (ends[1].revents != 0 && !write_some()) return Error{"", how_it_ended()};
    if (ends[0].revents == 0) continue;
    return read_some() ? Result<void>() : Error{"", how_it_ended()};
  }
}

bool Browser::write_some() {
  const ssize_t count = ::write(to_, outgoing_.data() + sent_, outgoing_.size() - sent_);
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  sent_ += static_cast<std::size_t>(count);
  if (sent_ < outgoing_.size()) return true;
  outgoing_.clear();
  sent_ = 0;
  return true;
}

bool Browser::read_some() {
  std::array<char, 1 << 16> bytes;
  const ssize_t count = ::read(from_, bytes.data(), bytes.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  incoming_.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0;
}

/// Pipes are closed: waits for the exit, or kills it.
std::string Browser::how_it_ended() {
  int status = 0;
  for (int tries = 0; tries < kTries; ++tries) {
    const pid_t ended = ::waitpid(child_, &status, WNOHANG);
    if (ended == child_) {
      ::kill(-child_, SIGKILL);
      child_ = 0;
      return WIFEXITED(status) ? fmt::format("ended with exit code {}", WEXITSTATUS(status))
                               : fmt::format("ended by signal {}", WTERMSIG(status));
    }
    std::this_thread::sleep_for(kBetweenTries);
  }
  return "closed its pipes";
}

void Browser::end() {
  close_end(to_);
  close_end(from_);
  if (child_ > 0) {
    ::kill(-child_, SIGKILL);
    while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
    child_ = 0;
  }
  for (int tries = 0; !folder_.empty() && tries < kTries; ++tries) {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
    if (!error) break;
    std::this_thread::sleep_for(kBetweenTries);
  }
  folder_.clear();
}

}  // namespace playhouse::app
