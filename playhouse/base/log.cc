#include "playhouse/base/log.h"

#include <fcntl.h>
#include <spdlog/details/os.h>
#include <spdlog/sinks/base_sink.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "playhouse/base/line_writer.h"
#include "playhouse/base/log_output.h"

namespace playhouse::log {
namespace {

/// Erases the progress line, if there is one, and what is written next takes its place.
constexpr const char* kEraseLine = "\r\x1b[K";

LineWriter& standard_error() {
  static LineWriter writer(STDERR_FILENO);
  return writer;
}

bool is_terminal() {
  return isatty(STDERR_FILENO) == 1;
}

const char* color_of(spdlog::level::level_enum level) {
  switch (level) {
    case spdlog::level::err:
      return "\x1b[1;31m";
    case spdlog::level::warn:
      return "\x1b[1;33m";
    case spdlog::level::info:
      return "\x1b[32m";
    default:
      return "\x1b[36m";
  }
}

/// Gives spdlog's lines to a writer.
class WriterSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  WriterSink(LineWriter& writer, bool colored) : writer_(writer), colored_(colored) {}

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t text;
    formatter_->format(message, text);
    std::string line(text.data(), text.size());
    if (colored_ && message.color_range_end > message.color_range_start) {
      line.insert(message.color_range_end, "\x1b[m");
      line.insert(message.color_range_start, color_of(message.level));
    }
    writer_.add(line);
  }
  void flush_() override { writer_.flush(); }

  LineWriter& writer_;
  bool colored_;
};

}  // namespace

void open(int level) {
  const bool colored = is_terminal() && spdlog::details::os::is_color_terminal();
  auto sink = std::make_shared<WriterSink>(standard_error(), colored);
  sink->set_pattern((is_terminal() ? kEraseLine : "") + std::string("%^%l%$: %v"));
  auto logger = std::make_shared<spdlog::logger>("playhouse", std::move(sink));
  logger->set_level(level <= 0   ? spdlog::level::warn
                    : level == 1 ? spdlog::level::info
                                 : spdlog::level::debug);
  spdlog::set_default_logger(std::move(logger));
}

Result<void> also_to(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return Error{path, "the log file cannot be written: " + std::string(std::strerror(errno))};
  static LineWriter writer(file);
  auto sink = std::make_shared<WriterSink>(writer, false);
  sink->set_pattern("[%Y-%m-%d %H:%M:%S.%e] %l: %v");
  spdlog::default_logger()->sinks().push_back(std::move(sink));
  return {};
}

void say(const std::string& line) {
  standard_error().add((is_terminal() ? kEraseLine : "") + line + "\n");
}

void show_progress(const std::string& text) {
  standard_error().show(kEraseLine + text);
}

bool flush() {
  spdlog::default_logger()->flush();
  return standard_error().flush();
}

}  // namespace playhouse::log
