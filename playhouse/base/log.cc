#include "playhouse/base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>

#include <memory>

namespace playhouse::log {

void open(int level) {
  auto logger = std::make_shared<spdlog::logger>("playhouse", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  logger->set_pattern("%^%l%$: %v");
  logger->set_level(level <= 0 ? spdlog::level::warn : level == 1 ? spdlog::level::info : spdlog::level::debug);
  spdlog::set_default_logger(std::move(logger));
}

}  // namespace playhouse::log
