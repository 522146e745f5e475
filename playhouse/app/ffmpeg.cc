#include "playhouse/app/ffmpeg.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

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
  ~Ffmpeg() { static_cast<void>(end()); }

  Result<void> start(std::vector<std::string> words) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return Error{"", std::string("no pipe: ") + std::strerror(errno)};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
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

 private:
  pid_t child_ = 0;
  int pipe_ = -1;
};

}  // namespace

Result<void> film_by_ffmpeg(const std::string& file, const View& view, double period,
                            const std::function<Result<void>(const PictureTaker&)>& each) {
  Ffmpeg ffmpeg;
  // Most players need even sizes and 4:2:0 chroma. "file:"
  // keeps a name from being parsed as an option or a URL.
  const Result<void> started = ffmpeg.start(
      {"ffmpeg", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size",
       fmt::format("{}x{}", view.width, view.height), "-framerate", fmt::format("{:.6g}", 1 / period), "-i",
       "pipe:0", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-y", "file:" + file});
  if (!started) return started;
  const Result<void> drawn = each([&](const Picture& picture) -> Result<void> {
    if (ffmpeg.write(picture.rgb)) return {};
    return Error{"", "is not written: ffmpeg ended early"};
  });
  const bool ended_well = ffmpeg.end();
  if (!drawn) return drawn;
  if (!ended_well) return Error{"", "is not written: ffmpeg failed"};
  return {};
}

}  // namespace playhouse::app
