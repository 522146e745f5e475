#pragma once

/// Robots that clients spawn over the network, described in TOML (docs/robot-client.md).

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/geom/pose.h"

namespace playhouse::scene {

struct RobotDesc {
  struct SensorDesc {
    std::string type;
    std::optional<geom::Pose> X_RS;  // in the robot; none: from its type
  };
  std::string where;  // "file:line"
  std::string type;
  std::string name;                        // "": chosen by the server
  geom::Pose X_WR;                         // x, y and heading
  std::optional<std::uint16_t> port;       // port for its devices; 0: any free one
  std::string color;                       // "": that of the type
  std::vector<SensorDesc> sensors;         // in addition to those of its type
  std::map<std::string, int> first_index;  // first device index by interface; default 0
};

inline constexpr std::size_t kRobotsOfFile = 1024;

/// Parses a file with one robot, or several as [[robot]]. Fails
/// with one error, "file:line: what (did you mean "x"?)".
Result<std::vector<RobotDesc>> read_robots(const std::string& text, const std::string& path);

}  // namespace playhouse::scene
