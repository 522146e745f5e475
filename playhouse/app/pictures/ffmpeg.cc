#include "playhouse/app/pictures/ffmpeg.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "playhouse/base/in_quotes.h"

extern char** environ;

namespace playhouse::app {
namespace {

constexpr const char* kNone =
    "is a film that ffmpeg makes, which is not in PATH; -o FILE.png makes an animated PNG without it";

/// The ffmpeg process and the pipe to its standard input.
class Ffmpeg {
 public:
  Ffmpeg() = default;
  Ffmpeg(const Ffmpeg&) = delete;
  Ffmpeg& operator=(const Ffmpeg&) = delete;
  ~Ffmpeg() {
    static_cast<void>(end());
    if (said_ >= 0) ::close(said_);
  }

  Result<void> start(std::vector<std::string> words) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return Error{"", std::string("no pipe: ") + std::strerror(errno)};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    said_ = ::memfd_create("ffmpeg", MFD_CLOEXEC);
    if (said_ >= 0) ::posix_spawn_file_actions_adddup2(&actions, said_, STDERR_FILENO);
    const int error = ::posix_spawnp(&child_, arguments[0], &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[0]);
    pipe_ = ends[1];
    if (error == 0) return {};
    child_ = 0;
    return Error{"", error == ENOENT ? kNone : std::string("ffmpeg: ") + std::strerror(error)};
  }

  /// False if ffmpeg has closed the pipe.
  bool write(const std::vector<std::uint8_t>& bytes) const {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t count = ::write(pipe_, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      done += static_cast<std::size_t>(count);
    }
    return true;
  }

  /// True if it succeeded. Call once.
  bool end() {
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = -1;
    if (child_ == 0) return false;
    int status = 1;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = 0;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  /// The first line of its standard error, without "[part @ address] "; empty if there is none. After end().
  std::string first_line() const {
    char text[256];
    const ssize_t size = said_ >= 0 ? ::pread(said_, text, sizeof(text), 0) : 0;
    std::string line(text, static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    line.erase(std::min(line.find('\n'), line.size()));
    const std::size_t end = line.starts_with('[') ? line.find("] ") : std::string::npos;
    return escaped(end == std::string::npos ? line : line.substr(end + 2));
  }

 private:
  pid_t child_ = 0;
  int pipe_ = -1;
  int said_ = -1;  // its standard error, in memory
};

}  // namespace

Result<void> film_by_ffmpeg(const std::string& file, const Viewport& view, double period,
                            const std::function<Result<void>(const PictureTaker&)>& each) {
  Ffmpeg ffmpeg;
  // Most players need even sizes and 4:2:0 chroma. "file:"
  // keeps a name from being parsed as an option or a URL.
  const Result<void> started = ffmpeg.start(
      {"ffmpeg", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size",
       fmt::format("{}x{}", view.width, view.height), "-framerate", fmt::format("{:.6g}", 1 / period), "-i",
       "pipe:0", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-y", "file:" + file});
  if (!started) return started;
  bool ended_early = false;
  const Result<void> drawn = each([&](const scene::RgbImage& picture) -> Result<void> {
    ended_early = !ffmpeg.write(picture.rgb);
    return ended_early ? Error{"", ""} : Result<void>();
  });
  const bool ended_well = ffmpeg.end();
  if (!drawn && !ended_early) return drawn;
  if (ended_well && !ended_early) return {};
  const std::string line = ffmpeg.first_line();
  return Error{"", "is not written: ffmpeg" + (!line.empty() ? ": " + line
                                               : ended_early ? " ended early"
                                                             : " failed")};
}

}  // namespace playhouse::app
