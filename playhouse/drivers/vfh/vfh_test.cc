// The driver "vfh" between a client and a simulated robot that stands still: what reaches the wheels, and
// when.

#include "playhouse/drivers/vfh/vfh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "playhouse/drivers/testing/memory_site.h"
#include "playhouse/drivers/testing/refusal_of.h"
#include "playhouse/wire/codec.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MemorySite;
using ::testing::StartsWith;
namespace p2d = wire::position2d;

constexpr device::Address kWheels{6665, 4, 0}, kVfh{6665, 4, 1};
constexpr std::uint8_t kCmd = 2, kReq = 3;

constexpr const char* kWorld = R"(
interval_sim 100
position( name "r0" size [0.4 0.4 0.2] ranger( sensor( range [0 8] fov 180 samples 181 ) ) )
)";

// From the last in the chain to the first.
std::string chain(const std::string& options) {
  return "driver( name \"vfh\" provides [\"position2d:1\"] requires [\"laser:0\" \"position2d:0\"] " +
         options +
         R"( )
driver( name "rangertolaser" provides ["laser:0"] requires ["ranger:0"] )
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["position2d:0" "ranger:0"] model "r0" ))";
}

std::string fault(const std::string& cfg) {
  MemorySite site(kWorld);
  return site.build(cfg);
}

class VfhTest : public ::testing::Test {
 protected:
  VfhTest() : site(kWorld) {
    EXPECT_EQ(site.build(chain("")), "");
    world().positions.motor_on[0] = 1;
    std::ranges::fill(world().sensors.ranges, 8.0f);
    EXPECT_TRUE(site.hold(site.id(kVfh)));
  }
  world::World& world() { return site.site().simulation()->engine().world(); }
  device::Driver& driver() { return site.driver(kVfh); }
  device::Taken say(std::uint8_t subtype, const std::vector<std::byte>& body) {
    return driver().command({site.id(kVfh), kCmd, subtype, body});
  }
  device::Taken go_to(double x, double y) {
    return say(p2d::kCmdPos, wire::encode(p2d::CmdPos{{x, y, 0}, {}, 1}));
  }
  device::Taken drive(double speed) { return say(p2d::kCmdVel, wire::encode(p2d::CmdVel{{speed, 0, 0}, 1})); }
  /// What the wheels were told last, once the inbox is empty.
  geom::Twist told() {
    site.run(0);
    return world().positions.command[0];
  }

  MemorySite site;
};

TEST_F(VfhTest, shows_its_robot_s_data_as_its_own_in_the_same_batch) {
  site.run(1);
  std::vector<std::uint32_t> devices;
  for (const device::Publication& publication : site.recorder.published)
    devices.push_back(publication.device.row);
  EXPECT_THAT(devices, ElementsAre(site.id(kWheels).row, site.id({6665, 62, 0}).row,
                                   site.id({6665, 62, 0}).row, site.id({6665, 6, 0}).row, site.id(kVfh).row));
  EXPECT_EQ(site.recorder.batches, 1);
  EXPECT_EQ(site.recorder.published.back().body, site.recorder.published.front().body);
}

TEST_F(VfhTest, a_scan_becomes_a_command_one_tick_later) {
  EXPECT_EQ(go_to(0, 3), device::Taken::kLatest);
  site.run(1);
  EXPECT_EQ(told().a, 0) << "the scan of this tick is being looked at";
  site.run(1);
  EXPECT_DOUBLE_EQ(told().a, geom::radians(40)) << "the goal is to its left";
}

TEST_F(VfhTest, velocities_pass_through_and_end_the_drive_to_a_goal) {
  go_to(0, 3);
  site.run(2);
  EXPECT_EQ(drive(0.3), device::Taken::kLatest);
  EXPECT_EQ(told(), (geom::Twist{0.3, 0, 0, 0}));
  site.run(3);
  EXPECT_EQ(told(), (geom::Twist{0.3, 0, 0, 0}));
}

TEST_F(VfhTest, a_command_that_the_robot_refuses_stops_it_if_it_was_driving_to_a_goal) {
  go_to(0, 3);
  site.run(2);
  EXPECT_NE(told().a, 0);
  EXPECT_EQ(drive(std::numeric_limits<double>::quiet_NaN()), device::Taken::kNo);
  EXPECT_EQ(told(), geom::Twist());
  drive(0.3);
  EXPECT_EQ(drive(std::numeric_limits<double>::quiet_NaN()), device::Taken::kNo);
  EXPECT_EQ(told().x, 0.3) << "else it is the robot's own matter";
}

TEST_F(VfhTest, a_goal_that_is_no_place_changes_nothing) {
  go_to(0, 3);
  site.run(2);
  EXPECT_EQ(go_to(std::numeric_limits<double>::infinity(), 0), device::Taken::kNo);
  site.run(2);
  EXPECT_NE(told().a, 0);
}

TEST_F(VfhTest, closed_on_its_way_it_leaves_a_robot_that_stands) {
  ASSERT_TRUE(site.hold(site.id(kWheels))) << "by somebody else";
  go_to(0, 3);
  site.run(2);
  EXPECT_NE(told().a, 0);
  site.release(site.id(kVfh));
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(site.held[site.id({6665, 6, 0}).row].size(), 0u);
  EXPECT_EQ(site.held[site.id(kWheels).row].size(), 1u);
}

TEST_F(VfhTest, a_goal_for_a_closed_device_is_not_kept_for_the_next_who_opens_it) {
  site.release(site.id(kVfh));
  EXPECT_EQ(go_to(0, 3), device::Taken::kNo);
  ASSERT_TRUE(site.hold(site.id(kVfh)));
  site.run(2);
  EXPECT_EQ(told(), geom::Twist());
}

TEST_F(VfhTest, at_its_goal_it_stands_and_leaves_the_robot_to_others) {
  go_to(0.1, 0);
  site.run(2);
  EXPECT_EQ(told(), geom::Twist());
  const std::vector<std::byte> turn = wire::encode(p2d::CmdVel{{0, 0, 0.5}, 1});
  site.driver(kWheels).command({site.id(kWheels), kCmd, p2d::kCmdVel, turn});
  site.run(2);
  EXPECT_EQ(told().a, 0.5);
}

TEST_F(VfhTest, goals_may_come_in_every_tick) {
  for (int tick = 0; tick < 5; ++tick) {
    go_to(0, 3 + tick % 2);
    site.run(1);
  }
  EXPECT_GT(told().a, 0) << "they are to its left";
}

TEST_F(VfhTest, requests_are_its_robot_s) {
  const auto answer = [this](std::uint8_t subtype, const std::vector<std::byte>& body) {
    driver().request({site.id(kVfh), kReq, subtype, body}, device::Replier(site.recorder, subtype));
    site.run(0);
    return site.recorder.answers.at(subtype);
  };
  const auto geometry = wire::decode<p2d::Geom>(answer(p2d::kReqGetGeom, {}).body);
  ASSERT_TRUE(geometry);
  EXPECT_DOUBLE_EQ(geometry->size.sl, 0.4);
  EXPECT_TRUE(answer(p2d::kReqMotorPower, wire::encode(p2d::PowerConfig{0})).ack);
  EXPECT_EQ(world().positions.motor_on[0], 0);
  EXPECT_TRUE(answer(p2d::kReqSetOdom, wire::encode(p2d::SetOdomReq{{1, 2, 0}})).ack);
  EXPECT_FALSE(answer(p2d::kReqSpeedProf, wire::encode(p2d::SpeedProfReq{})).ack);
  EXPECT_TRUE(driver().capable(site.id(kVfh), kReq, p2d::kReqSetOdom));
  EXPECT_FALSE(driver().capable(site.id(kVfh), kReq, p2d::kReqSpeedProf));
  EXPECT_TRUE(driver().capable(site.id(kVfh), kCmd, p2d::kCmdPos));
}

TEST_F(VfhTest, the_directory_shows_it_at_its_robot) {
  EXPECT_EQ(site.site().model_devices()->directory().model_of(kVfh),
            site.site().model_devices()->directory().model_of(kWheels));
}

TEST_F(VfhTest, goes_with_its_robot_amid_a_drive_and_so_does_the_laser_between_them) {
  run::Simulation& simulation = *site.site().simulation();
  const device::DeviceId vfh = site.id(kVfh);
  device::Driver& driver = site.driver(kVfh);
  go_to(0, 3);
  site.run(1);
  ASSERT_TRUE(simulation.requests().post([](world::Journal& journal) { EXPECT_TRUE(journal.despawn({0})); }));
  site.run(3);
  site.run(0);  // what was said on the io thread
  EXPECT_EQ(site.retired.size(), 4u);
  EXPECT_EQ(site.site().device_count(), 1u) << "the simulation";
  EXPECT_EQ(site.site().model_devices()->directory().size(), 0u);
  EXPECT_EQ(site.site().model_devices()->sources().size(), 0u);
  EXPECT_EQ(site.hold(vfh).error().text, "the device has retired");
  const std::vector<std::byte> goal = wire::encode(p2d::CmdPos{{0, 3, 0}, {}, 1});
  EXPECT_EQ(driver.command({vfh, kCmd, p2d::kCmdPos, goal}), device::Taken::kNo);
}

TEST_F(VfhTest, ends_its_drive_when_it_hears_that_a_device_of_its_retired_and_lets_go_of_the_other) {
  ASSERT_TRUE(site.hold(site.id(kWheels))) << "by somebody else";
  go_to(0, 3);
  site.run(2);
  EXPECT_NE(told().a, 0);
  site.retire_device(site.id({6665, 6, 0}));
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(site.held[site.id(kWheels).row].size(), 1u);
  EXPECT_EQ(go_to(0, 3), device::Taken::kNo);
  site.release(site.id(kVfh));  // has nothing left to let go of
  EXPECT_EQ(site.held[site.id(kWheels).row].size(), 1u);
}

/// The laser is no part of the robot.
constexpr const char* kApart = R"(
interval_sim 100
ranger( name "gate" sensor( range [0 8] fov 180 samples 181 ) )
position( name "r0" size [0.4 0.4 0.2] )
)";
constexpr const char* kApartFile = R"(
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["laser:0"] model "gate" )
driver( name "stage" provides ["position2d:0"] model "r0" alwayson 1 )
driver( name "vfh" provides ["position2d:1"] requires ["position2d:0" "laser:0"] ))";

TEST(VfhApart, tells_why_it_drives_to_no_goals) {
  testing::Mute laser;
  MemorySite site(kWorld);
  ASSERT_TRUE(site.site().add_device({6665, 6, 0}, laser));
  ASSERT_EQ(site.build(R"(
driver( name "vfh" provides ["position2d:1"] requires ["laser:0" "position2d:0"] )
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["position2d:0"] model "r0" ))"),
            "");
  ASSERT_TRUE(site.hold(site.id(kVfh)));
  const std::string why = "its laser does not tell its place, so it drives to no goals";
  EXPECT_EQ(testing::refusal_of(site, kVfh), "") << "it has no goal";
  const auto say = [&](std::uint8_t subtype, const std::vector<std::byte>& body) {
    return site.driver(kVfh).command({site.id(kVfh), kCmd, subtype, body});
  };
  EXPECT_EQ(say(p2d::kCmdPos, wire::encode(p2d::CmdPos{{1, 0, 0}, {}, 1})), device::Taken::kNo);
  EXPECT_EQ(testing::refusal_of(site, kVfh), why);
  EXPECT_EQ(say(p2d::kCmdVel, wire::encode(p2d::CmdVel{{0.1, 0, 0}, 1})), device::Taken::kLatest);
  EXPECT_EQ(testing::refusal_of(site, kVfh), "");
}

TEST(VfhApart, stops_its_robot_when_its_laser_goes) {
  MemorySite site(kApart);
  ASSERT_EQ(site.build(kApartFile), "");
  run::Simulation& simulation = *site.site().simulation();
  const world::World& world = simulation.world();
  const device::DeviceId vfh = site.id(kVfh), laser = site.id({6665, 6, 0});
  ASSERT_TRUE(site.hold(vfh));
  const std::vector<std::byte> goal = wire::encode(p2d::CmdPos{{0, 3, 0}, {}, 1});
  EXPECT_EQ(site.driver(kVfh).command({vfh, kCmd, p2d::kCmdPos, goal}), device::Taken::kLatest);
  site.run(3);
  EXPECT_NE(world.positions.command[0], geom::Twist());
  ASSERT_TRUE(simulation.requests().post([](world::Journal& journal) { EXPECT_TRUE(journal.despawn({0})); }));
  site.run(1);
  site.run(1);
  EXPECT_EQ(world.positions.command[0], geom::Twist());
  EXPECT_THAT(site.retired, ElementsAre(laser.row, vfh.row));
  EXPECT_TRUE(site.site().find(kWheels).has_value());
}

TEST(VfhSection, says_what_is_wrong_and_where) {
  EXPECT_THAT(fault(chain("sector_angle 7")), StartsWith("test.cfg:1: sector_angle divides 360"));
  EXPECT_THAT(fault(chain("window_diameter 5000")), HasSubstr("window_diameter is from 3 to 1001"));
  EXPECT_THAT(fault(chain("cell_size 0")), HasSubstr("cell_size is 0.005 at least"));
  EXPECT_THAT(fault(chain("max_speed -1")), HasSubstr("max_speed is 0 at least"));
  EXPECT_THAT(fault(chain("obs_cutoff_0ms 10")),
              HasSubstr("obs_cutoff_0ms is not below free_space_cutoff_0ms"));
  EXPECT_THAT(
      fault("driver( name \"vfh\" provides [\"position2d:1\"] requires [\"position2d:0\"] )"),
      HasSubstr("test.cfg:1: driver \"vfh\" requires one position2d and one laser, e.g. [\"position2d:0\" "
                "\"laser:0\"]"));
}

TEST(VfhSection, units_are_those_of_the_file) {
  EXPECT_THAT(fault(chain("max_turnrate_0ms \"fast\"")), HasSubstr("test.cfg:1"));
  EXPECT_EQ(fault("unit_length \"mm\"\n" + chain("max_speed 300 cell_size 100")), "");
}

TEST(Requires, a_circle_is_an_error_that_names_it) {
  const std::string stage = R"(
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["laser:0"] model "r0" )
)";
  EXPECT_EQ(
      fault(stage + R"(driver( name "vfh" provides ["position2d:1"] requires ["position2d:2" "laser:0"] )
driver( name "vfh" provides ["position2d:2"] requires ["position2d:1" "laser:0"] ))"),
      "test.cfg:4: devices require each other in a circle: \"position2d:2\", which requires "
      "\"position2d:1\", "
      "which requires the first");
  EXPECT_EQ(
      fault(stage +
            "driver( name \"vfh\" provides [\"position2d:1\"] requires [\"position2d:1\" \"laser:0\"] )"),
      "test.cfg:4: devices require each other in a circle: \"position2d:1\", which requires the first");
}

TEST(Requires, a_device_that_nobody_provides_gets_the_nearest_name) {
  EXPECT_THAT(
      fault(chain("") + "\ndriver( name \"vfh\" provides [\"6666:position2d:5\"] requires [\"position2d:7\" "
                        "\"laser:0\"] )"),
      HasSubstr("test.cfg:5: nothing provides \"position2d:7\" (did you mean \"position2d:0\"?)"));
}

}  // namespace
}  // namespace playhouse::drivers
