// The driver "nd" between a client and simulated robots that stand still: what reaches the wheels, and when.

#include "playhouse/drivers/nd/nd.h"
#include "playhouse/bridge/simulated/simulated_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/drivers/testing/goal_test.h"
#include "playhouse/drivers/testing/post_on_the_right.h"
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

constexpr device::Address kLaser{6665, 6, 0}, kSonar{6665, 5, 0};

constexpr const char* kWorld = R"(
interval_sim 100
define eye ranger( sensor( range [0 8] fov 180 samples 181 ) )
define ears ranger( sensor( range [0 5] fov 15 ) sensor( range [0 5] fov 15 pose [0 0 0 90] ) )
position( name "r0" size [0.4 0.4 0.2] ears() eye() )
position( name "r1" size [2 2 0.2] )
)";

/// A section of nd and those of two robots, from the last in the chain to the first.
std::string chain(const std::string& options, const std::string& scans = "\"laser:0\" \"sonar:0\"",
                  const std::string& input = "position2d:0") {
  return "driver( name \"nd\" provides [\"position2d:1\"] requires [\"output:::position2d:0\" \"input:::" +
         input + "\" " + scans + "] " + options + R"( )
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["position2d:0" "laser:0" "sonar:0"] model "r0" )
driver( name "stage" provides ["position2d:2"] model "r1" ))";
}

std::string fault(const std::string& cfg) {
  MemorySite site(kWorld);
  return site.build(cfg);
}

class NdTest : public testing::GoalTest {
 protected:
  explicit NdTest(const std::string& cfg = chain("")) : GoalTest(kWorld, cfg) {}
};

TEST_F(NdTest, gives_up_a_goal_to_which_it_does_not_get_and_says_so_until_the_next_command) {
  go_to(5, 0);
  site.run(20);
  EXPECT_EQ(told().x, 0.3);
  EXPECT_EQ(state().stall, 0);
  EXPECT_EQ(refusal(), "");
  site.run(5);
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(state().stall, 1);
  EXPECT_EQ(refusal(), "it gave up the goal (5, 0): the robot is stuck");
  site.run(20);
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(state().stall, 1);
  go_to(5, 0);
  site.run(2);
  EXPECT_EQ(told().x, 0.3);
  EXPECT_EQ(state().stall, 0);
  EXPECT_EQ(refusal(), "");
  site.run(25);
  EXPECT_EQ(state().stall, 1);
  drive(0.1);
  site.run(2);
  EXPECT_EQ(state().stall, 0);
  EXPECT_EQ(refusal(), "") << "it has no goal";
}

TEST_F(NdTest, goes_with_its_robot_amid_a_drive) {
  run::Simulation& simulation = *simulation_of(site.site());
  const device::DeviceId nd = site.id(kGoalDriver);
  device::Driver& gone = driver();
  go_to(0, 3);
  site.run(1);
  ASSERT_TRUE(simulation.requests().post([](world::Journal& journal) { EXPECT_TRUE(journal.despawn({0})); }));
  site.run(3);
  site.run(0);  // what was said on the io thread
  EXPECT_EQ(site.retired.size(), 4u);
  EXPECT_EQ(site.site().device_count(), 2u) << "the simulation and the other robot";
  EXPECT_EQ(site.hold(nd).error().text, "the device has retired");
  const std::vector<std::byte> goal = wire::encode(p2d::CmdPos{{0, 3, 0}, {}, 1});
  EXPECT_EQ(gone.command({nd, kCmd, p2d::kCmdPos, goal}), device::Taken::kNo);
}

TEST_F(NdTest, ends_its_drive_when_a_device_of_its_retires_and_lets_go_of_the_others) {
  ASSERT_TRUE(site.hold(site.id(kWheels))) << "by somebody else";
  go_to(0, 3);
  site.run(2);
  EXPECT_NE(told().a, 0);
  site.retire_device(site.id(kSonar));
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(holders(kWheels), 1u);
  EXPECT_EQ(holders(kLaser), 0u);
  EXPECT_EQ(go_to(0, 3), device::Taken::kNo);
}

class NdWaitingTest : public NdTest {
 protected:
  NdWaitingTest() : NdTest(chain("wait_on_stall 1")) {}
};

TEST_F(NdWaitingTest, waits_for_the_end_of_a_stall) {
  go_to(5, 0);
  site.run(2);
  EXPECT_EQ(told().x, 0.3);
  world().positions.stall[{0}] = 1;
  site.run(2);
  EXPECT_EQ(told(), geom::Twist());
  site.run(50);
  world().positions.stall[{0}] = 0;
  site.run(2);
  EXPECT_EQ(told().x, 0.3) << "the goal is still its goal";
  EXPECT_EQ(state().stall, 0);
}

class NdTwoRobotsTest : public NdTest {
 protected:
  NdTwoRobotsTest() : NdTest(chain("", "\"sonar:0\"", "position2d:2")) {}
};

TEST_F(NdTwoRobotsTest, the_pose_is_that_of_the_input_and_velocities_go_to_the_output) {
  world().positions.X_OM[{1}] = {1, 2, 0, 0};
  go_to(1, 5);
  site.run(2);
  EXPECT_EQ(state().pos.py, 2);
  EXPECT_DOUBLE_EQ(told({0}).a, geom::radians(45)) << "it is to the left of the input";
  EXPECT_EQ(told({0}).x, 0);
  EXPECT_EQ(told({1}), geom::Twist());
  drive(0.2);
  EXPECT_EQ(told({0}).x, 0.2);
  EXPECT_EQ(told({1}), geom::Twist());
}

TEST_F(NdTwoRobotsTest, sonars_alone_steer_it) {
  world().sensors.ranges[{0}] = 0.5f;  // ahead
  go_to(5, 0);
  site.run(2);
  EXPECT_GT(std::abs(told({0}).a), geom::radians(10));
}

geom::Twist told_by(const std::string& scans) {
  return testing::PostOnTheRight(
             "driver( name \"nd\" provides [\"position2d:1\"] requires [\"output:::position2d:0\" "
             "\"input:::position2d:0\" " +
             scans + "] )")
      .told();
}

TEST(NdScans, lead_to_the_same_velocity_whatever_interfaces_tell_them) {
  const geom::Twist by_laser = told_by("\"laser:0\"");
  EXPECT_GT(by_laser.a, geom::radians(5)) << "it turns away from the post";
  EXPECT_GT(by_laser.x, 0.02);
  for (const std::string scans : {"\"ranger:0\"", "\"ranger:1\"", "\"sonar:0\"", "\"laser:0\" \"ranger:1\"",
                                  "\"ranger:0\" \"sonar:0\"", "\"laser:0\" \"ranger:1\" \"sonar:0\""}) {
    const geom::Twist told = told_by(scans);
    EXPECT_NEAR(told.x, by_laser.x, 1e-6) << scans;
    EXPECT_NEAR(told.a, by_laser.a, 1e-6) << scans;
  }
}

TEST(NdSection, says_what_is_wrong_and_where) {
  EXPECT_THAT(fault(chain("max_speed [-1 45]")), StartsWith("test.cfg:1: max_speed is 0 at least"));
  EXPECT_THAT(fault(chain("min_speed [0.4 10]")), HasSubstr("min_speed is not above max_speed"));
  EXPECT_THAT(fault(chain("min_speed [0.05 50]")), HasSubstr("min_speed is not above max_speed"));
  EXPECT_THAT(fault(chain("laser_buffer 0")), HasSubstr("laser_buffer is from 1 to 1000"));
  EXPECT_THAT(fault(chain("goal_tol [-0.1 10]")), HasSubstr("goal_tol is 0 at least"));
  EXPECT_THAT(fault(chain("avoid_dist 0")), HasSubstr("avoid_dist is 0.001 at least"));
  EXPECT_THAT(fault(chain("rotate_stuck_time -1")), HasSubstr("rotate_stuck_time is 0 at least"));
  EXPECT_THAT(fault(chain("sonar_bad_transducers [0 \"left\"]")), HasSubstr("test.cfg:1"));
  EXPECT_EQ(fault(chain("sonar_bad_transducers [0 1]")), "");
}

TEST(NdSection, needs_an_input_an_output_and_a_laser_a_ranger_or_a_sonar) {
  EXPECT_EQ(fault(chain("", "\"laser:0\"")), "");
  EXPECT_EQ(fault(chain("", "\"sonar:0\"")), "");
  EXPECT_THAT(
      fault(chain("", "")),
      HasSubstr("test.cfg:1: driver \"nd\" requires one position2d of key output and one position2d of "
                "key input and one laser, ranger or sonar, e.g. [\"output:::position2d:0\" "
                "\"input:::position2d:0\" \"laser:0\"]"));
  EXPECT_THAT(
      fault("driver( name \"nd\" provides [\"position2d:1\"] requires [\"position2d:0\" \"laser:0\"] )"),
      HasSubstr("requires one position2d of key output"));
  EXPECT_THAT(fault(chain("", "\"laser:0\" \"fiducial:0\"")),
              HasSubstr("requires one position2d of key output"));
}

TEST(NdSection, units_are_those_of_the_file) {
  EXPECT_EQ(fault("unit_length \"mm\"\n" + chain("max_speed [300 45] avoid_dist 500")), "");
  EXPECT_THAT(fault("unit_length \"mm\"\n" + chain("avoid_dist 0.5")),
              HasSubstr("avoid_dist is 0.001 at least"));
}

}  // namespace
}  // namespace playhouse::drivers
