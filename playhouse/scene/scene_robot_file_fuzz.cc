/// Any bytes as a file of robots: reads or fails with a place and a text.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "playhouse/scene/robot_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace playhouse::scene;
  const auto robots = read_robots(std::string(reinterpret_cast<const char*>(bytes), size), "c/t.toml");
  if (!robots) {
    if (robots.error().text.empty() || robots.error().where.find(':') == std::string::npos) std::abort();
    return 0;
  }
  for (const RobotDesc& robot : *robots)
    if (robot.type.empty() || !std::isfinite(robot.X_WR.x) || !std::isfinite(robot.X_WR.a)) std::abort();
  return 0;
}
