#pragma once

/// A robot whose scanner and whose ring of as many sensors look from one place into the same directions, for
/// tests of drivers that use either: laser:0 and ranger:0 are the scanner, sonar:0 and ranger:1 the ring.

#include <cstdint>
#include <functional>
#include <string>

#include "playhouse/world/world.h"

namespace playhouse::drivers::testing {

inline constexpr std::uint32_t kTwoEyesBeams = 181;  // over 180 degrees, from right to left
inline constexpr const char* kTwoEyes[] = {"laser:0", "ranger:0", "ranger:1", "sonar:0"};

/// `more`: words of the robot "r0".
inline std::string two_eyes_world(const std::string& more = "") {
  std::string ring;
  for (std::uint32_t i = 0; i < kTwoEyesBeams; ++i) {
    ring += "sensor( range [0 8] fov 1 pose [0.1 0 0 " + std::to_string(static_cast<int>(i) - 90) + "] ) ";
  }
  return "interval_sim 100 position( name \"r0\" size [0.4 0.4 0.2] " + more +
         " ranger( sensor( range [0 8] fov 180 samples 181 pose [0.1 0 0 0] ) ) ranger( " + ring + " ) )";
}

inline constexpr const char* kTwoEyesStage = R"(
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["position2d:0" "laser:0" "sonar:0" "ranger:0" "ranger:1"] model "r0" ))";

/// What both see, by the degrees of a direction from -90 to 90.
inline void see(world::World& world, const std::function<double(int)>& range) {
  for (std::uint32_t i = 0; i < kTwoEyesBeams; ++i) {
    const auto seen = static_cast<float>(range(static_cast<int>(i) - 90));
    world.sensors.ranges[{i}] = world.sensors.ranges[{kTwoEyesBeams + i}] = seen;
  }
}

}  // namespace playhouse::drivers::testing
