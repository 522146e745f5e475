#include "playhouse/base/log.h"

#include <fcntl.h>
#include <spdlog/details/os.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "playhouse/base/before_abort.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/line_limits.h"
#include "playhouse/base/line_writer.h"
#include "playhouse/base/log_at.h"
#include "playhouse/base/log_output.h"
#include "playhouse/base/monotonic.h"

namespace playhouse::log {
namespace {

/// Erases the progress line, so that the next text replaces it.
constexpr const char* kEraseLine = "\r\x1b[K";

LineWriter& standard_error() {
  static LineWriter writer(STDERR_FILENO);
  return writer;
}

bool is_terminal() {
  return isatty(STDERR_FILENO) == 1;
}

/// https://no-color.org: any non-empty value.
bool refuses_color() {
  const char* const value = std::getenv("NO_COLOR");
  return value != nullptr && *value != '\0';
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

spdlog::level::level_enum spdlog_level(Level level) {
  switch (level) {
    case Level::kDebug:
      return spdlog::level::debug;
    case Level::kInfo:
      return spdlog::level::info;
    case Level::kWarn:
      return spdlog::level::warn;
    case Level::kError:
      break;
  }
  return spdlog::level::err;
}

/// Passes spdlog's lines to a writer.
class WriterSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  WriterSink(LineWriter& writer, bool colored) : writer_(writer), colored_(colored) {}

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    // Control characters of any origin must not reach a terminal.
    const std::string payload = escaped({message.payload.data(), message.payload.size()});
    spdlog::details::log_msg shown = message;
    shown.payload = payload;
    spdlog::memory_buf_t text;
    formatter_->format(shown, text);
    std::string line(text.data(), text.size());
    if (colored_) {
      line.insert(shown.color_range_end, "\x1b[m");
      line.insert(shown.color_range_start, color_of(shown.level));
    }
    if (!shown.source.empty()) line.insert(shown.color_range_start, escaped(shown.source.filename) + ": ");
    writer_.add(line);
  }
  void flush_() override { writer_.flush(); }

  LineWriter& writer_;
  bool colored_;
};

/// Rate limits, active after open(); tests are not limited.
struct Limited {
  std::mutex mutex;
  bool on = false;
  LineLimits limits;
};
Limited& limited() {
  static Limited limited;
  return limited;
}

void give_all(const std::vector<LineLimits::Line>& lines) {
  for (const LineLimits::Line& line : lines) tell(static_cast<Level>(line.level), {line.place, line.text});
}

/// Summaries of suppressed lines.
std::vector<LineLimits::Line> held_back() {
  const std::lock_guard lock(limited().mutex);
  return limited().limits.summaries(monotonic_seconds());
}

}  // namespace

void open(int level) {
  limited().on = true;
  set_before_abort(&flush);
  const bool colored = is_terminal() && spdlog::details::os::is_color_terminal() && !refuses_color();
  auto sink = std::make_shared<WriterSink>(standard_error(), colored);
  sink->set_pattern((is_terminal() ? kEraseLine : "") + std::string("%^%l%$: %v"));
  auto logger = std::make_shared<spdlog::logger>("playhouse", std::move(sink));
  logger->set_level(level <= 0   ? spdlog::level::warn
                    : level == 1 ? spdlog::level::info
                                 : spdlog::level::debug);
  spdlog::set_default_logger(std::move(logger));
}

void silence() {
  spdlog::set_level(spdlog::level::off);
}

Result<void> also_to(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return Error{path, "the log file cannot be written: " + std::string(std::strerror(errno))};
  static LineWriter writer(file);
  auto sink = std::make_shared<WriterSink>(writer, false);
  sink->set_pattern("[%Y-%m-%d %H:%M:%S.%e] %^%l%$: %v");
  spdlog::default_logger()->sinks().push_back(std::move(sink));
  return {};
}

void write(Level level, fmt::string_view format, fmt::format_args values) {
  write_at(level, "", format, values);
}

void write_at(Level level, const std::string& place, fmt::string_view format, fmt::format_args values) {
  if (!spdlog::should_log(spdlog_level(level))) return;
  std::string line = fmt::vformat(format, values);
  const std::string_view kind(format.data(), format.size());
  if (kind == "{}" || !limited().on) return tell(level, {place, line});
  std::vector<LineLimits::Line> lines;
  {
    const std::lock_guard lock(limited().mutex);
    lines =
        limited().limits.pass(kind, {static_cast<int>(level), std::move(line), place}, monotonic_seconds());
  }
  give_all(lines);
}

void tell(Level level, const Error& finding) {
  const int anywhere = finding.where.empty() ? 0 : 1;  // 0: no position
  spdlog::default_logger()->log(spdlog::source_loc{finding.where.c_str(), anywhere, ""}, spdlog_level(level),
                                finding.text);
}

void say(const std::string& line) {
  standard_error().add((is_terminal() ? kEraseLine : "") + line + "\n");
}

void show_progress(const std::string& text) {
  standard_error().show(kEraseLine + text);
}

bool flush() {
  give_all(held_back());
  spdlog::default_logger()->flush();
  return standard_error().flush();
}

}  // namespace playhouse::log
