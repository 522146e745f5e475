#include "playhouse/base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <unistd.h>

#include <memory>
#include <string>

namespace playhouse::log {

void open(int level) {
  auto logger = std::make_shared<spdlog::logger>("playhouse", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  // On a terminal a line may begin behind the progress line (app/house.cc), which it takes the place of.
  const std::string start = isatty(STDERR_FILENO) == 1 ? "\r\x1b[K" : "";
  logger->set_pattern(start + "%^%l%$: %v");
  logger->set_level(level <= 0 ? spdlog::level::warn : level == 1 ? spdlog::level::info : spdlog::level::debug);
  spdlog::set_default_logger(std::move(logger));
}

}  // namespace playhouse::log
