#pragma once

/// A fixture for tests of drivers that drive a robot to goals: position2d:0 are its wheels, position2d:1 is the
/// driver.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/testing/refusal_of.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers::testing {

inline constexpr device::Address kWheels{6665, 4, 0}, kGoalDriver{6665, 4, 1};
inline constexpr std::uint8_t kCmd = 2, kReq = 3;

class GoalTest : public ::testing::Test {
 protected:
  /// The driver is open, motors are on, and scans are of 8 m.
  GoalTest(const std::string& world_text, const std::string& cfg) : site(world_text) {
    EXPECT_EQ(site.build(cfg), "");
    std::ranges::fill(world().positions.motor_on, std::uint8_t{1});
    std::ranges::fill(world().sensors.ranges, 8.0f);
    EXPECT_TRUE(site.hold(site.id(kGoalDriver)));
  }
  world::World& world() { return simulation_of(site.site())->engine().world(); }
  device::Driver& driver() { return site.driver(kGoalDriver); }
  device::Taken say(std::uint8_t subtype, const std::vector<std::byte>& body) {
    return driver().command({site.id(kGoalDriver), kCmd, subtype, body});
  }
  device::Taken go_to(double x, double y) {
    return say(wire::position2d::kCmdPos, wire::encode(wire::position2d::CmdPos{{x, y, 0}, {}, 1}));
  }
  device::Taken drive(double speed) {
    return say(wire::position2d::kCmdVel, wire::encode(wire::position2d::CmdVel{{speed, 0, 0}, 1}));
  }
  /// What the wheels of a robot were told last, once the inbox is empty.
  geom::Twist told(world::PositionRow robot = {0}) {
    site.run(0);
    return world().positions.command[robot];
  }
  std::size_t holders(device::Address device) { return site.held[site.id(device).row].size(); }
  /// The driver's newest STATE.
  wire::position2d::Data state() {
    wire::position2d::Data newest;
    for (const device::Publication& publication : site.recorder.published) {
      if (publication.device == site.id(kGoalDriver) && publication.subtype == wire::position2d::kDataState)
        newest = *wire::decode<wire::position2d::Data>(publication.body);
    }
    return newest;
  }
  std::string refusal() { return refusal_of(site, kGoalDriver); }

  MemorySite site;
};

}  // namespace playhouse::drivers::testing
