#include "playhouse/drivers/simulated/auto_map.h"

#include <gtest/gtest.h>

#include "playhouse/drivers/testing/still_engine.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

/// "interface:index=model" per device, in order.
std::vector<std::string> mapped(const std::string& text) {
  const scene::SceneDesc scene = testing::scene_of(text);
  const world::World world(scene, 1);
  std::vector<std::string> lines;
  for (const MappedDevice& device : auto_map(world).devices) {
    std::string line(wire::find_interface(device.interf)->name);
    line += ":" + std::to_string(device.index);
    if (device.model) line += "=" + world.desc(device.model).name;
    lines.push_back(line);
  }
  return lines;
}

constexpr const char* kMacros = R"(
define laser ranger( sensor( samples 180 fov 180 ) )
define sonars ranger( sensor( pose [0 0 0 0] ) sensor( pose [0 0 0 90] ) )
)";

using Lines = std::vector<std::string>;

TEST(AutoMap, an_empty_world_is_a_simulation) {
  EXPECT_EQ(mapped(""), Lines{"simulation:0"});
}

TEST(AutoMap, gives_every_robot_its_number_for_wheels_laser_and_sonar) {
  EXPECT_EQ(mapped(std::string(kMacros) + R"(
position( name "a" sonars( name "s" ) laser( name "l" ) )
model( name "box" )
position( name "b" laser( name "l" ) fiducial( name "f" ) ))"),
            (Lines{"simulation:0", "position2d:0=a", "ranger:0=a.s", "sonar:0=a.s", "ranger:1=a.l",
                   "laser:0=a.l", "position2d:1=b", "ranger:2=b.l", "laser:1=b.l", "fiducial:0=b.f"}));
}

TEST(AutoMap, a_robot_without_a_laser_leaves_its_number_free) {
  EXPECT_EQ(mapped(std::string(kMacros) + R"(
position( name "blind" )
position( name "b" laser( name "l" ) ))"),
            (Lines{"simulation:0", "position2d:0=blind", "position2d:1=b", "ranger:0=b.l", "laser:1=b.l"}));
}

TEST(AutoMap, further_lasers_of_a_robot_come_behind_all_robots) {
  EXPECT_EQ(mapped(std::string(kMacros) + R"(
position( name "a" laser( name "front" ) laser( name "rear" ) )
position( name "b" laser( name "l" ) ))"),
            (Lines{"simulation:0", "position2d:0=a", "ranger:0=a.front", "laser:0=a.front", "ranger:1=a.rear",
                   "position2d:1=b", "ranger:2=b.l", "laser:1=b.l", "laser:2=a.rear"}));
}

TEST(AutoMap, sensors_that_no_robot_carries_are_devices_too) {
  EXPECT_EQ(mapped(std::string(kMacros) + R"(
laser( name "gate" )
position( name "a" laser( name "l" ) ))"),
            (Lines{"simulation:0", "position2d:0=a", "ranger:0=a.l", "laser:0=a.l", "ranger:1=gate",
                   "laser:1=gate"}));
}

}  // namespace
}  // namespace playhouse::drivers
