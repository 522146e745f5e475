// The driver "nd" between a client and simulated robots that stand still: what reaches the wheels, and when.

#include "playhouse/drivers/nd/nd.h"

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

constexpr device::Address kWheels{6665, 4, 0}, kNd{6665, 4, 1}, kLaser{6665, 6, 0}, kSonar{6665, 5, 0};
constexpr std::uint8_t kCmd = 2, kReq = 3;

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

class NdTest : public ::testing::Test {
 protected:
  explicit NdTest(const std::string& cfg = chain("")) : site(kWorld) {
    EXPECT_EQ(site.build(cfg), "");
    for (const std::size_t robot : {0, 1}) world().positions.motor_on[robot] = 1;
    std::ranges::fill(world().sensors.ranges, 8.0f);
    EXPECT_TRUE(site.hold(site.id(kNd)));
  }
  world::World& world() { return site.site().simulation()->engine().world(); }
  device::Driver& driver() { return site.driver(kNd); }
  device::Taken say(std::uint8_t subtype, const std::vector<std::byte>& body) {
    return driver().command({site.id(kNd), kCmd, subtype, body});
  }
  device::Taken go_to(double x, double y) {
    return say(p2d::kCmdPos, wire::encode(p2d::CmdPos{{x, y, 0}, {}, 1}));
  }
  device::Taken drive(double speed) { return say(p2d::kCmdVel, wire::encode(p2d::CmdVel{{speed, 0, 0}, 1})); }
  /// What the wheels of a robot were told last, once the inbox is empty.
  geom::Twist told(std::size_t robot = 0) {
    site.run(0);
    return world().positions.command[robot];
  }
  std::string refusal() { return testing::refusal_of(site, kNd); }
  /// The last STATE of nd.
  p2d::Data state() {
    p2d::Data newest;
    for (const device::Publication& publication : site.recorder.published) {
      if (publication.device == site.id(kNd) && publication.subtype == p2d::kDataState)
        newest = *wire::decode<p2d::Data>(publication.body);
    }
    return newest;
  }

  MemorySite site;
};

TEST_F(NdTest, shows_its_robot_s_data_as_its_own_in_the_same_batch) {
  site.run(1);
  std::vector<std::uint32_t> devices;
  for (const device::Publication& publication : site.recorder.published)
    devices.push_back(publication.device.row);
  EXPECT_EQ(std::ranges::count(devices, site.id(kNd).row), 1);
  EXPECT_EQ(std::ranges::count(devices, site.id(kWheels).row), 1);
  EXPECT_EQ(site.recorder.batches, 1);
  EXPECT_EQ(devices.back(), site.id(kNd).row);
}

TEST_F(NdTest, a_scan_becomes_a_command_one_tick_later) {
  EXPECT_EQ(go_to(0, 3), device::Taken::kLatest);
  site.run(1);
  EXPECT_EQ(told().a, 0) << "the scan of this tick is being looked at";
  site.run(1);
  EXPECT_DOUBLE_EQ(told().a, geom::radians(45)) << "the goal is to its left";
}

TEST_F(NdTest, velocities_pass_through_and_end_the_drive_to_a_goal) {
  go_to(0, 3);
  site.run(2);
  EXPECT_EQ(drive(0.3), device::Taken::kLatest);
  EXPECT_EQ(told(), (geom::Twist{0.3, 0, 0, 0}));
  site.run(3);
  EXPECT_EQ(told(), (geom::Twist{0.3, 0, 0, 0}));
}

TEST_F(NdTest, a_command_that_the_robot_refuses_stops_it_if_it_was_driving_to_a_goal) {
  go_to(0, 3);
  site.run(2);
  EXPECT_NE(told().a, 0);
  EXPECT_EQ(drive(std::numeric_limits<double>::quiet_NaN()), device::Taken::kNo);
  EXPECT_EQ(told(), geom::Twist());
  drive(0.3);
  EXPECT_EQ(drive(std::numeric_limits<double>::quiet_NaN()), device::Taken::kNo);
  EXPECT_EQ(told().x, 0.3) << "else it is the robot's own matter";
}

TEST_F(NdTest, a_goal_that_is_no_place_changes_nothing) {
  go_to(0, 3);
  site.run(2);
  EXPECT_EQ(go_to(std::numeric_limits<double>::infinity(), 0), device::Taken::kNo);
  site.run(2);
  EXPECT_NE(told().a, 0);
}

TEST_F(NdTest, closed_on_its_way_it_leaves_a_robot_that_stands) {
  ASSERT_TRUE(site.hold(site.id(kWheels))) << "by somebody else";
  go_to(0, 3);
  site.run(2);
  EXPECT_NE(told().a, 0);
  site.release(site.id(kNd));
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(site.held[site.id(kLaser).row].size(), 0u);
  EXPECT_EQ(site.held[site.id(kSonar).row].size(), 0u);
  EXPECT_EQ(site.held[site.id(kWheels).row].size(), 1u);
}

TEST_F(NdTest, a_goal_for_a_closed_device_is_not_kept_for_the_next_who_opens_it) {
  site.release(site.id(kNd));
  EXPECT_EQ(go_to(0, 3), device::Taken::kNo);
  ASSERT_TRUE(site.hold(site.id(kNd)));
  site.run(2);
  EXPECT_EQ(told(), geom::Twist());
}

TEST_F(NdTest, at_its_goal_it_stands_and_leaves_the_robot_to_others) {
  go_to(0.1, 0);
  site.run(2);
  EXPECT_EQ(told(), geom::Twist());
  const std::vector<std::byte> turn = wire::encode(p2d::CmdVel{{0, 0, 0.5}, 1});
  site.driver(kWheels).command({site.id(kWheels), kCmd, p2d::kCmdVel, turn});
  site.run(40);
  EXPECT_EQ(told().a, 0.5);
  EXPECT_EQ(state().stall, 0);
}

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

TEST_F(NdTest, a_goal_beyond_its_numbers_is_refused_in_words) {
  EXPECT_EQ(go_to(1e300, 0), device::Taken::kNo);
  EXPECT_EQ(refusal(), "invalid goal: a pose within 1e9 m and 1e9 rad is valid");
  go_to(0, 3);
  EXPECT_EQ(refusal(), "");
}

TEST_F(NdTest, keeps_its_goal_when_the_run_is_taken_back) {
  go_to(0, 3);
  site.run(3);
  EXPECT_NE(told().a, 0);
  static_cast<Shell&>(driver()).rewound({1, 0.1, 1});
  world().positions.command[0] = {};
  EXPECT_EQ(told(), geom::Twist()) << "what was computed before is not said";
  site.run(2);
  EXPECT_DOUBLE_EQ(told().a, geom::radians(45));
}

TEST_F(NdTest, has_no_goal_after_a_restart) {
  run::Simulation& simulation = *site.site().simulation();
  simulation.requests().record(true);
  site.run(1);
  const std::uint64_t start = simulation.requests().timeline()->ticks.front();
  go_to(0, 3);
  site.run(3);
  EXPECT_NE(told().a, 0);
  run::testing::rewind_to(simulation, start, 1);
  site.run(3);
  EXPECT_EQ(told(), geom::Twist());
}

TEST_F(NdTest, goals_may_come_in_every_tick) {
  for (int tick = 0; tick < 5; ++tick) {
    go_to(0, 3 + tick % 2);
    site.run(1);
  }
  EXPECT_GT(told().a, 0) << "they are to its left";
}

TEST_F(NdTest, requests_are_its_robot_s) {
  const auto answer = [this](std::uint8_t subtype, const std::vector<std::byte>& body) {
    driver().request({site.id(kNd), kReq, subtype, body}, device::Replier(site.recorder, subtype));
    site.run(0);
    return site.recorder.answers.at(subtype);
  };
  const auto geometry = wire::decode<p2d::Geom>(answer(p2d::kReqGetGeom, {}).body);
  ASSERT_TRUE(geometry);
  EXPECT_DOUBLE_EQ(geometry->size.sl, 0.4);
  EXPECT_TRUE(answer(p2d::kReqMotorPower, wire::encode(p2d::PowerConfig{0})).ack);
  EXPECT_EQ(world().positions.motor_on[0], 0);
  EXPECT_FALSE(answer(p2d::kReqSpeedProf, wire::encode(p2d::SpeedProfReq{})).ack);
  EXPECT_TRUE(driver().capable(site.id(kNd), kReq, p2d::kReqSetOdom));
  EXPECT_FALSE(driver().capable(site.id(kNd), kReq, p2d::kReqSpeedProf));
  EXPECT_TRUE(driver().capable(site.id(kNd), kCmd, p2d::kCmdPos));
}

TEST_F(NdTest, the_directory_shows_it_at_its_robot) {
  EXPECT_EQ(site.site().model_devices()->directory().model_of(kNd),
            site.site().model_devices()->directory().model_of(kWheels));
}

TEST_F(NdTest, goes_with_its_robot_amid_a_drive) {
  run::Simulation& simulation = *site.site().simulation();
  const device::DeviceId nd = site.id(kNd);
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
  EXPECT_EQ(site.held[site.id(kWheels).row].size(), 1u);
  EXPECT_EQ(site.held[site.id(kLaser).row].size(), 0u);
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
  world().positions.stall[0] = 1;
  site.run(2);
  EXPECT_EQ(told(), geom::Twist());
  site.run(50);
  world().positions.stall[0] = 0;
  site.run(2);
  EXPECT_EQ(told().x, 0.3) << "the goal is still its goal";
  EXPECT_EQ(state().stall, 0);
}

class NdTwoRobotsTest : public NdTest {
 protected:
  NdTwoRobotsTest() : NdTest(chain("", "\"sonar:0\"", "position2d:2")) {}
};

TEST_F(NdTwoRobotsTest, the_pose_is_that_of_the_input_and_velocities_go_to_the_output) {
  world().positions.X_OM[1] = {1, 2, 0, 0};
  go_to(1, 5);
  site.run(2);
  EXPECT_EQ(state().pos.py, 2);
  EXPECT_DOUBLE_EQ(told(0).a, geom::radians(45)) << "it is to the left of the input";
  EXPECT_EQ(told(0).x, 0);
  EXPECT_EQ(told(1), geom::Twist());
  drive(0.2);
  EXPECT_EQ(told(0).x, 0.2);
  EXPECT_EQ(told(1), geom::Twist());
}

TEST_F(NdTwoRobotsTest, sonars_alone_steer_it) {
  world().sensors.ranges[0] = 0.5f;  // ahead
  go_to(5, 0);
  site.run(2);
  EXPECT_GT(std::abs(told(0).a), geom::radians(10));
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

TEST(NdSection, needs_an_input_an_output_and_a_laser_or_a_sonar) {
  EXPECT_EQ(fault(chain("", "\"laser:0\"")), "");
  EXPECT_EQ(fault(chain("", "\"sonar:0\"")), "");
  EXPECT_THAT(
      fault(chain("", "")),
      HasSubstr("test.cfg:1: driver \"nd\" requires one position2d of key output and one position2d of "
                "key input and one laser, e.g. [\"output:::position2d:0\" \"input:::position2d:0\" "
                "\"laser:0\"]"));
  EXPECT_THAT(
      fault("driver( name \"nd\" provides [\"position2d:1\"] requires [\"position2d:0\" \"laser:0\"] )"),
      HasSubstr("requires one position2d of key output"));
  EXPECT_THAT(fault(chain("", "\"laser:0\" \"ranger:0\"")),
              HasSubstr("requires one position2d of key output"));
}

TEST(NdSection, units_are_those_of_the_file) {
  EXPECT_EQ(fault("unit_length \"mm\"\n" + chain("max_speed [300 45] avoid_dist 500")), "");
  EXPECT_THAT(fault("unit_length \"mm\"\n" + chain("avoid_dist 0.5")),
              HasSubstr("avoid_dist is 0.001 at least"));
}

}  // namespace
}  // namespace playhouse::drivers
