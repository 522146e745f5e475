#include "playhouse/bridge/simulated/auto_map.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/model_interfaces.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

/// "interface:index=model" per device, in order; behind the first port "port+interface:index=model".
std::vector<std::string> mapped(const std::string& text, AutoMap map = AutoMap()) {
  const scene::SceneDesc scene = run::testing::scene_of(text);
  const world::World world(scene, 1);
  std::vector<std::string> lines;
  for (const MappedDevice& device : map.of_world(world)) {
    std::string line = device.port > 0 ? std::to_string(device.port) + "+" : "";
    line += wire::find_interface(device.interf)->name;
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
  EXPECT_EQ(
      mapped(std::string(kMacros) + R"(
position( name "a" sonars( name "s" ) laser( name "l" ) )
model( name "box" )
position( name "b" laser( name "l" ) fiducial( name "f" ) ))"),
      (Lines{"simulation:0", "position2d:0=a", "position3d:0=a", "speech:0=a", "speech_recognition:0=a",
             "ranger:0=a.s", "sonar:0=a.s", "ranger:1=a.l", "laser:0=a.l", "position2d:1=b", "position3d:1=b",
             "speech:1=b", "speech_recognition:1=b", "ranger:2=b.l", "laser:1=b.l", "fiducial:0=b.f"}));
}

TEST(AutoMap, a_robot_without_a_laser_leaves_its_number_free) {
  EXPECT_EQ(mapped(std::string(kMacros) + R"(
position( name "blind" )
position( name "b" laser( name "l" ) ))"),
            (Lines{"simulation:0", "position2d:0=blind", "position3d:0=blind", "speech:0=blind",
                   "speech_recognition:0=blind", "position2d:1=b", "position3d:1=b", "speech:1=b",
                   "speech_recognition:1=b", "ranger:0=b.l", "laser:1=b.l"}));
}

TEST(AutoMap, further_lasers_of_a_robot_come_behind_all_robots) {
  EXPECT_EQ(
      mapped(std::string(kMacros) + R"(
position( name "a" laser( name "front" ) laser( name "rear" ) )
position( name "b" laser( name "l" ) ))"),
      (Lines{"simulation:0", "position2d:0=a", "position3d:0=a", "speech:0=a", "speech_recognition:0=a",
             "ranger:0=a.front", "laser:0=a.front", "ranger:1=a.rear", "position2d:1=b", "position3d:1=b",
             "speech:1=b", "speech_recognition:1=b", "ranger:2=b.l", "laser:1=b.l", "laser:2=a.rear"}));
}

TEST(AutoMap, sensors_that_no_robot_carries_are_devices_too) {
  EXPECT_EQ(mapped(std::string(kMacros) + R"(
laser( name "gate" )
position( name "a" laser( name "l" ) ))"),
            (Lines{"simulation:0", "position2d:0=a", "position3d:0=a", "speech:0=a", "speech_recognition:0=a",
                   "ranger:0=a.l", "laser:0=a.l", "ranger:1=gate", "laser:1=gate"}));
}

TEST(AutoMap, lists_carried_wheels_where_they_are_and_further_lasers_and_sonars_last) {
  EXPECT_EQ(mapped(std::string(kMacros) + R"(
position( name "solo" )
model( name "cart" position( name "p" laser( name "l" ) ) fiducial( name "f" ) )
position( name "a" laser( name "l" ) laser( name "m" ) position( name "p" sonars( name "s" ) sonars( name "t" ) ) )
sonars( name "gate" )
position( name "b" fiducial( name "f" ) laser( name "l" ) laser( name "m" ) sonars( name "s" ) ))"),
            (Lines{"simulation:0",
                   "position2d:0=solo",
                   "position3d:0=solo",
                   "speech:0=solo",
                   "speech_recognition:0=solo",
                   "position2d:1=a",
                   "position3d:1=a",
                   "speech:1=a",
                   "speech_recognition:1=a",
                   "ranger:0=a.l",
                   "laser:1=a.l",
                   "ranger:1=a.m",
                   "position2d:3=a.p",
                   "ranger:2=a.p.s",
                   "sonar:1=a.p.s",
                   "ranger:3=a.p.t",
                   "position2d:2=b",
                   "position3d:2=b",
                   "speech:2=b",
                   "speech_recognition:2=b",
                   "fiducial:0=b.f",
                   "ranger:4=b.l",
                   "laser:2=b.l",
                   "ranger:5=b.m",
                   "ranger:6=b.s",
                   "sonar:2=b.s",
                   "position2d:4=cart.p",
                   "ranger:7=cart.p.l",
                   "fiducial:1=cart.f",
                   "ranger:8=gate",
                   "laser:3=a.m",
                   "position3d:3=a.p",
                   "sonar:3=a.p.t",
                   "laser:4=b.m",
                   "position3d:4=cart.p",
                   "laser:5=cart.p.l",
                   "sonar:4=gate"}));
}

TEST(AutoMap, continues_on_the_following_ports_and_the_world_is_on_each) {
  EXPECT_EQ(mapped(std::string(kMacros) + R"(
position( name "a" laser( name "l" ) laser( name "m" ) )
position( name "b" )
position( name "c" laser( name "l" ) )
laser( name "gate" ))",
                   AutoMap(2)),
            (Lines{"simulation:0",
                   "1+simulation:0",
                   "position2d:0=a",
                   "position3d:0=a",
                   "speech:0=a",
                   "speech_recognition:0=a",
                   "ranger:0=a.l",
                   "laser:0=a.l",
                   "ranger:1=a.m",
                   "position2d:1=b",
                   "position3d:1=b",
                   "speech:1=b",
                   "speech_recognition:1=b",
                   "1+position2d:0=c",
                   "1+position3d:0=c",
                   "1+speech:0=c",
                   "1+speech_recognition:0=c",
                   "1+ranger:0=c.l",
                   "1+laser:0=c.l",
                   "1+ranger:1=gate",
                   "1+laser:1=a.m",
                   "2+simulation:0",
                   "2+laser:0=gate"}));
}

TEST(AutoMap, robot_k_is_on_port_k_by_indices_at_the_rest) {
  constexpr std::size_t kRobots = 1000, kIndices = 300;
  std::string text;
  for (std::size_t k = 0; k < kRobots; ++k) text += fmt::format("position( name \"r{}\" )\n", k);
  const scene::SceneDesc scene = run::testing::scene_of(text);
  const world::World world(scene, 1);
  AutoMap map(kIndices);
  std::size_t robots = 0, worlds = 0;
  for (const MappedDevice& device : map.of_world(world)) {
    worlds += !device.model;
    if (!device.model) EXPECT_EQ(device.index, 0u);
    if (!device.model) continue;
    ++robots;
    const std::size_t k = device.port * kIndices + device.index;
    EXPECT_LT(device.index, kIndices);
    EXPECT_EQ(world.name(device.model), fmt::format("r{}", k));
  }
  EXPECT_EQ(robots, kRobots * 4) << "position2d, position3d, speech, speech_recognition";
  EXPECT_EQ(worlds, 4u);
  EXPECT_EQ(map.ports(), 4u);
  EXPECT_EQ(map.left_out(), 0u);
}

TEST(AutoMap, leaves_out_what_no_port_has_room_for_and_asks_for_a_port_once) {
  std::string text;
  for (std::size_t k = 0; k < 10; ++k) text += fmt::format("position( name \"r{}\" )\n", k);
  const scene::SceneDesc scene = run::testing::scene_of(text);
  const world::World world(scene, 1);
  std::vector<std::size_t> asked;
  AutoMap map(4, [&](std::size_t port) {
    asked.push_back(port);
    return port < 2;
  });
  EXPECT_EQ(map.of_world(world).size(), 2 + 8 * 4u);
  EXPECT_EQ(asked, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(map.ports(), 2u);
  EXPECT_EQ(map.left_out(), 2 * 4u);
  AutoMap narrow(1);
  std::string crowd;
  for (std::size_t k = 0; k < AutoMap::kPorts + 1; ++k) crowd += fmt::format("position( name \"r{}\" )\n", k);
  const scene::SceneDesc crowded = run::testing::scene_of(crowd);
  EXPECT_EQ(narrow.of_world(world::World(crowded, 1)).size(), AutoMap::kPorts * 5);
  EXPECT_EQ(narrow.left_out(), 4u);
}

TEST(AutoMap, every_interface_of_what_is_simulated_has_a_device) {
  std::string text =
      std::string(kMacros) +
      "position( joules 1 laser( ) sonars( ) ranger( sensor( rings 2 ) ) camera( baseline 0.1 ) )";
  for (const scene::Kind& kind : scene::kinds())
    if (kind.entity == scene::EntityForm::kModel && kind.simulated) text += fmt::format(" {}( )", kind.name);
  testing::StillDevices still(text);
  AutoMap map;
  std::set<std::uint16_t> made, simulated;
  for (const MappedDevice& device : map.of_world(still.world())) {
    EXPECT_NE(make_device(still.devices, device.interf, device.model), nullptr);
    made.insert(device.interf);
  }
  const std::set<std::uint16_t> listed = made;
  for (const world::ModelRow model : still.world().models.rows())
    each_interface(still.world(), model, [&](const scene::KindInterface& each) {
      if (each.listed != scene::Need::kNever || !has(still.world(), model, each.when)) return;
      EXPECT_NE(make_device(still.devices, each.code, model), nullptr);
      EXPECT_FALSE(listed.contains(each.code)) << "devices of configuration files alone";
      made.insert(each.code);
    });
  for (const wire::InterfaceDef& interf : wire::interfaces())
    if (is_simulated(interf.code)) simulated.insert(interf.code);
  EXPECT_EQ(made, simulated);
}

}  // namespace
}  // namespace playhouse::drivers
