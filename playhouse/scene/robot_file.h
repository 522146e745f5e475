#pragma once

/// Robots that join a world over the network, as a TOML file describes them (docs/robot-client.md).

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/geom/pose.h"

namespace playhouse::scene {

struct RobotDesc {
  struct Sensor {
    std::string type;
    std::optional<geom::Pose> X_RS;  // in the robot; none: as its type says
  };
  std::string where;  // "file:line"
  std::string type;
  std::string name;                        // "": the server gives one
  geom::Pose X_WR;                         // x, y and heading
  std::optional<std::uint16_t> port;       // on which its devices are served; 0: any free one
  std::string color;                       // "": the type's
  std::vector<Sensor> sensors;             // that it carries beside those of its type
  std::map<std::string, int> first_index;  // of its devices, by interface; else 0
};

inline constexpr std::size_t kRobotsOfFile = 1024;

/// The file is a robot, or has several as [[robot]]. Fails with one error, "file:line: what (did you mean
/// "x"?)".
Result<std::vector<RobotDesc>> read_robots(const std::string& text, const std::string& path);

}  // namespace playhouse::scene
