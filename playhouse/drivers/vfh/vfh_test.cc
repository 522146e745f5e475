// The driver "vfh" between a client and a simulated robot that stands still: what reaches the wheels, and
// when.

#include "playhouse/drivers/vfh/vfh.h"
#include "playhouse/bridge/simulated/simulated_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/drivers/testing/goal_test.h"
#include "playhouse/drivers/testing/post_on_the_right.h"
#include "playhouse/drivers/testing/two_eyes.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kCmd;
using testing::kGoalDriver;
using testing::kWheels;
using testing::MemorySite;
using ::testing::StartsWith;
namespace p2d = wire::position2d;
namespace planner = wire::planner;

constexpr device::Address kPlanner{6665, planner::kCode, 0};

constexpr const char* kWorld = R"(
interval_sim 100
position( name "r0" size [0.4 0.4 0.2] ranger( sensor( range [0 8] fov 180 samples 181 ) ) )
)";

// From the last in the chain to the first.
std::string chain(const std::string& options, const std::string& provides = "\"position2d:1\"") {
  return "driver( name \"vfh\" provides [" + provides + "] requires [\"laser:0\" \"position2d:0\"] " +
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

class VfhTest : public testing::GoalTest {
 protected:
  explicit VfhTest(const std::string& provides = "\"position2d:1\"")
      : GoalTest(kWorld, chain("", provides)) {}
};

TEST_F(VfhTest, goes_with_its_robot_amid_a_drive_and_so_does_the_laser_between_them) {
  run::Simulation& simulation = *simulation_of(site.site());
  const device::DeviceId vfh = site.id(kGoalDriver);
  device::Driver& driver = site.driver(kGoalDriver);
  go_to(0, 3);
  site.run(1);
  ASSERT_TRUE(simulation.requests().post([](world::Journal& journal) { EXPECT_TRUE(journal.despawn({0})); }));
  site.run(3);
  site.run(0);  // what was said on the io thread
  EXPECT_EQ(site.retired.size(), 4u);
  EXPECT_EQ(site.site().device_count(), 1u) << "the simulation";
  EXPECT_EQ(model_devices_of(site.site())->directory().size(), 0u);
  EXPECT_EQ(model_devices_of(site.site())->sources().size(), 0u);
  EXPECT_EQ(site.hold(vfh).error().text, "the device has retired");
  const std::vector<std::byte> goal = wire::encode(p2d::CmdPos{{0, 3, 0}, {}, 1});
  EXPECT_EQ(driver.command({vfh, kCmd, p2d::kCmdPos, goal}), device::Taken::kNo);
}

geom::Twist told_by(const std::string& scans) {
  return testing::PostOnTheRight(
             "driver( name \"vfh\" provides [\"position2d:1\"] requires [\"position2d:0\" \"" + scans +
             "\"] )")
      .told();
}

TEST(VfhScans, lead_to_the_same_velocity_whatever_interface_tells_them) {
  const geom::Twist by_laser = told_by("laser:0");
  EXPECT_GT(by_laser.a, geom::radians(5)) << "it turns away from the post";
  EXPECT_GT(by_laser.x, 0.02);
  for (const char* const scans : testing::kTwoEyes) {
    const geom::Twist told = told_by(scans);
    EXPECT_NEAR(told.x, by_laser.x, 1e-6) << scans;
    EXPECT_NEAR(told.a, by_laser.a, 1e-6) << scans;
  }
}

class VfhPlannerTest : public VfhTest {
 protected:
  VfhPlannerTest() : VfhTest("\"position2d:1\" \"planner:0\"") { EXPECT_TRUE(site.hold(site.id(kPlanner))); }
  device::Taken plan(std::uint8_t subtype, const wire::Pose2d& goal) {
    return driver().command({site.id(kPlanner), kCmd, subtype, wire::encode(planner::Cmd{goal})});
  }
  testing::OutputRecorder::RecordedAnswer ask(std::uint8_t subtype, const std::vector<std::byte>& body) {
    driver().request({site.id(kPlanner), testing::kReq, subtype, body}, device::Replier(site.recorder, 1));
    site.run(0);
    return site.recorder.answers.at(1);
  }
  bool enable(bool on) {
    return ask(planner::kReqEnable, wire::encode(planner::EnableReq{static_cast<std::uint8_t>(on)})).ack;
  }
  planner::Data plan_state() {
    site.run(1);
    planner::Data newest;
    for (const device::Publication& each : site.recorder.published)
      if (each.device == site.id(kPlanner)) newest = *wire::decode<planner::Data>(each.body);
    return newest;
  }
  void robot_at(const geom::Pose& X_OR) { world().positions.X_OM[{0}] = X_OR; }
};

TEST_F(VfhPlannerTest, takes_goals_in_the_frame_of_odometry_and_says_when_it_is_there) {
  robot_at({1, 2, 0, 0});
  EXPECT_EQ(plan_state(), (planner::Data{0, 0, {1, 2, 0}, {}, {}, -1, 0}));
  const wire::Pose2d goal{4, 6, 0};
  EXPECT_EQ(plan(planner::kCmdGoal, goal), device::Taken::kLatest);
  EXPECT_EQ(plan_state(), (planner::Data{1, 0, {1, 2, 0}, goal, goal, 0, 1}));
  site.run(2);
  EXPECT_GT(told().a, 0) << "the goal is on its left";
  const auto way = wire::decode<planner::WaypointsReq>(ask(planner::kReqGetWaypoints, {}).body);
  ASSERT_TRUE(way);
  EXPECT_DOUBLE_EQ(way->waypoints_distance, 5);
  EXPECT_THAT(way->waypoints, ElementsAre(goal));
  robot_at({4, 5.9, 0, 0});
  site.run(3);
  EXPECT_EQ(plan_state(), (planner::Data{1, 1, {4, 5.9, 0}, goal, {}, -1, 1}));
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(drive(0.1), device::Taken::kLatest);
  EXPECT_EQ(plan_state().valid, 0) << "a velocity ends it";
}

TEST_F(VfhPlannerTest, keeps_its_goal_while_it_is_disabled) {
  EXPECT_EQ(plan(planner::kCmdGoal, {0, 5, 0}), device::Taken::kLatest);
  site.run(3);
  EXPECT_NE(told(), geom::Twist());
  EXPECT_TRUE(enable(false));
  site.run(3);
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(plan_state().valid, 1);
  EXPECT_EQ(refusal(), "it is disabled: ENABLE 1 lets it drive on");
  EXPECT_EQ(plan(planner::kCmdGoal, {0, 6, 0}), device::Taken::kLatest);
  site.run(3);
  EXPECT_EQ(told(), geom::Twist()) << "a GOAL does not enable";
  EXPECT_TRUE(enable(true));
  site.run(3);
  EXPECT_NE(told(), geom::Twist());
  EXPECT_TRUE(enable(false));
  EXPECT_EQ(plan(planner::kCmdStart, {0, 7, 0}), device::Taken::kLatest);
  site.run(3);
  EXPECT_NE(told(), geom::Twist()) << "a START does";
  EXPECT_EQ(refusal(), "");
}

TEST_F(VfhPlannerTest, passes_nothing_to_the_robot_that_is_meant_for_a_planner) {
  const auto has = [&](device::Address device) {
    return driver().capable(site.id(device), testing::kReq, p2d::kReqResetOdom);
  };
  EXPECT_TRUE(has(kGoalDriver));
  EXPECT_FALSE(has(kPlanner));
  EXPECT_FALSE(ask(p2d::kReqResetOdom, {}).ack);
  EXPECT_EQ(plan(99, {}), device::Taken::kNo);
  EXPECT_EQ(plan(planner::kCmdGoal, {std::nan(""), 0, 0}), device::Taken::kNo);
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
  ASSERT_TRUE(site.hold(site.id(kGoalDriver)));
  const std::string why = "its laser does not tell its place, so it drives to no goals";
  EXPECT_EQ(testing::refusal_of(site, kGoalDriver), "") << "it has no goal";
  const auto say = [&](std::uint8_t subtype, const std::vector<std::byte>& body) {
    return site.driver(kGoalDriver).command({site.id(kGoalDriver), kCmd, subtype, body});
  };
  EXPECT_EQ(say(p2d::kCmdPos, wire::encode(p2d::CmdPos{{1, 0, 0}, {}, 1})), device::Taken::kNo);
  EXPECT_EQ(testing::refusal_of(site, kGoalDriver), why);
  EXPECT_EQ(say(p2d::kCmdVel, wire::encode(p2d::CmdVel{{0.1, 0, 0}, 1})), device::Taken::kLatest);
  EXPECT_EQ(testing::refusal_of(site, kGoalDriver), "");
}

TEST(VfhApart, stops_its_robot_when_its_laser_goes) {
  MemorySite site(kApart);
  ASSERT_EQ(site.build(kApartFile), "");
  run::Simulation& simulation = *simulation_of(site.site());
  const world::World& world = simulation.world();
  const device::DeviceId vfh = site.id(kGoalDriver), laser = site.id({6665, 6, 0});
  ASSERT_TRUE(site.hold(vfh));
  const std::vector<std::byte> goal = wire::encode(p2d::CmdPos{{0, 3, 0}, {}, 1});
  EXPECT_EQ(site.driver(kGoalDriver).command({vfh, kCmd, p2d::kCmdPos, goal}), device::Taken::kLatest);
  site.run(3);
  EXPECT_NE(world.positions.command[{0}], geom::Twist());
  ASSERT_TRUE(simulation.requests().post([](world::Journal& journal) { EXPECT_TRUE(journal.despawn({0})); }));
  site.run(1);
  site.run(1);
  EXPECT_EQ(world.positions.command[{0}], geom::Twist());
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
      HasSubstr("test.cfg:1: driver \"vfh\" requires one position2d and one laser, ranger or sonar, e.g. "
                "[\"position2d:0\" \"laser:0\"]"));
  EXPECT_THAT(fault("driver( name \"vfh\" provides [\"position2d:1\"] requires [\"position2d:0\" \"laser:0\" "
                    "\"sonar:0\"] )"),
              HasSubstr("requires one position2d and one laser, ranger or sonar, e.g."));
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
