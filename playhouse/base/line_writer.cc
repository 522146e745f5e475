#include "playhouse/base/line_writer.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <iterator>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace playhouse {
namespace {

/// Write errors are ignored: they cannot be reported.
void write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {  // a parent may have made it non-blocking
      pollfd room{file, POLLOUT, 0};
      poll(&room, 1, -1);
    } else if (errno != EINTR) {
      return;
    }
  }
}

/// Blocks all signals in this thread, and in threads started meanwhile.
class NoSignals {
 public:
  NoSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~NoSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

struct LineWriter::State {
  explicit State(int the_file) : file(the_file) {}

  const int file;
  std::mutex mutex;  // guards all below; not held while writing
  std::condition_variable changed;
  std::string lines;     // queued
  std::size_t lost = 0;  // lines dropped after these
  std::string status;    // pending
  bool started = false, writing = false, ending = false;
  bool stalled = false;  // flush() has timed out on the current write

  bool waiting() const { return !lines.empty() || lost > 0 || !status.empty(); }

  /// The next text to write. Needs the mutex.
  std::string take() {
    if (lines.empty() && lost == 0) return std::exchange(status, {});
    std::string text = std::exchange(lines, {});
    if (lost > 0) fmt::format_to(std::back_inserter(text), "warning: {} lines of the log were lost\n", lost);
    lost = 0;
    return text;
  }

  /// Writes until nothing is queued. Needs the lock, and releases it during writes.
  void write_waiting(std::unique_lock<std::mutex>& lock) {
    while (waiting()) {
      const std::string text = take();
      writing = true;
      lock.unlock();
      write_all(file, text);
      lock.lock();
      writing = stalled = false;
    }
    changed.notify_all();
  }

  /// Thread main function.
  void run() {
    std::unique_lock lock(mutex);
    while (!ending) {
      write_waiting(lock);
      changed.wait(lock, [this] { return ending || waiting(); });
    }
    write_waiting(lock);
  }

  /// Wakes or starts the thread. Needs the lock.
  static void wake(const std::shared_ptr<State>& state, std::unique_lock<std::mutex>& lock) {
    if (state->started) return state->changed.notify_all();
    try {
      const NoSignals none;  // they are for threads that wait for them
      std::thread([state] { state->run(); }).detach();
      state->started = true;
    } catch (const std::system_error&) {  // no thread available: written later
      if (!state->writing) state->write_waiting(lock);
    }
  }
};

LineWriter::LineWriter(int file) : state_(std::make_shared<State>(file)) {}

LineWriter::~LineWriter() {
  flush();
  const std::lock_guard lock(state_->mutex);
  state_->ending = true;
  state_->changed.notify_all();
}

void LineWriter::add(std::string_view line) {
  std::unique_lock lock(state_->mutex);
  if (state_->lost > 0 || state_->lines.size() + line.size() > kBytes) {
    ++state_->lost;  // after one loss all are dropped, so that the count is in the right place
  } else {
    state_->lines += line;
  }
  State::wake(state_, lock);
}

void LineWriter::show(std::string status) {
  std::unique_lock lock(state_->mutex);
  state_->status = std::move(status);
  State::wake(state_, lock);
}

bool LineWriter::flush(std::chrono::milliseconds patience) {
  std::unique_lock lock(state_->mutex);
  if (state_->stalled) return false;  // once is enough
  const bool written =
      state_->changed.wait_for(lock, patience, [this] { return !state_->waiting() && !state_->writing; });
  state_->stalled = !written;
  return written;
}

}  // namespace playhouse
