// What all drivers to goals have in common, between a client and a simulated robot that stands still.

#include "playhouse/drivers/algorithm/goal_algorithm.h"
#include "playhouse/bridge/simulated/simulated_world.h"

#include <gtest/gtest.h>

#include <limits>

#include "playhouse/drivers/testing/goal_test.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

using testing::kCmd;
using testing::kGoalDriver;
using testing::kReq;
using testing::kWheels;
namespace p2d = wire::position2d;

constexpr device::Address kLaser{6665, 6, 0};

constexpr const char* kWorld = R"(
interval_sim 100
position( name "r0" size [0.4 0.4 0.2] ranger( sensor( range [0 8] fov 180 samples 181 ) ) )
)";

struct GoalDriver {
  const char* name;
  const char* requires_;
  double turn;  // degrees/s, towards a goal to its left
};

class AnyGoalTest : public testing::GoalTest, public ::testing::WithParamInterface<GoalDriver> {
 protected:
  AnyGoalTest()
      : GoalTest(kWorld, std::string("driver( name \"") + GetParam().name +
                             R"(" provides ["position2d:1"] requires [)" + GetParam().requires_ + R"(] )
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["position2d:0" "laser:0"] model "r0" ))") {}
  double turn() const { return geom::radians(GetParam().turn); }
};

INSTANTIATE_TEST_SUITE_P(
    Drivers, AnyGoalTest,
    ::testing::Values(GoalDriver{"vfh", R"("position2d:0" "laser:0")", 40},
                      GoalDriver{"nd", R"("output:::position2d:0" "input:::position2d:0" "laser:0")", 45}),
    [](const auto& each) { return std::string(each.param.name); });

TEST_P(AnyGoalTest, shows_its_robot_s_data_as_its_own_in_the_same_batch) {
  site.run(1);
  EXPECT_EQ(site.recorder.batches, 1);
  ASSERT_EQ(site.recorder.published.size(), 3u) << "the wheels, the laser and itself";
  EXPECT_EQ(site.recorder.published.back().device, site.id(kGoalDriver));
  EXPECT_EQ(site.recorder.published.front().device, site.id(kWheels));
  EXPECT_EQ(site.recorder.published.back().body, site.recorder.published.front().body);
}

TEST_P(AnyGoalTest, a_scan_becomes_a_command_one_tick_later) {
  EXPECT_EQ(go_to(0, 3), device::Taken::kLatest);
  site.run(1);
  EXPECT_EQ(told().a, 0) << "the scan of this tick is being looked at";
  site.run(1);
  EXPECT_DOUBLE_EQ(told().a, turn()) << "the goal is to its left";
}

TEST_P(AnyGoalTest, velocities_pass_through_and_end_the_drive_to_a_goal) {
  go_to(0, 3);
  site.run(2);
  EXPECT_EQ(drive(0.3), device::Taken::kLatest);
  EXPECT_EQ(told(), (geom::Twist{0.3, 0, 0, 0}));
  site.run(3);
  EXPECT_EQ(told(), (geom::Twist{0.3, 0, 0, 0}));
}

TEST_P(AnyGoalTest, a_command_that_the_robot_refuses_stops_it_if_it_was_driving_to_a_goal) {
  go_to(0, 3);
  site.run(2);
  EXPECT_NE(told().a, 0);
  EXPECT_EQ(drive(std::numeric_limits<double>::quiet_NaN()), device::Taken::kNo);
  EXPECT_EQ(told(), geom::Twist());
  drive(0.3);
  EXPECT_EQ(drive(std::numeric_limits<double>::quiet_NaN()), device::Taken::kNo);
  EXPECT_EQ(told().x, 0.3) << "else it is the robot's own matter";
}

TEST_P(AnyGoalTest, a_goal_that_is_no_place_changes_nothing) {
  go_to(0, 3);
  site.run(2);
  EXPECT_EQ(go_to(std::numeric_limits<double>::infinity(), 0), device::Taken::kNo);
  site.run(2);
  EXPECT_NE(told().a, 0);
}

TEST_P(AnyGoalTest, closed_on_its_way_it_leaves_a_robot_that_stands) {
  ASSERT_TRUE(site.hold(site.id(kWheels))) << "by somebody else";
  go_to(0, 3);
  site.run(2);
  EXPECT_NE(told().a, 0);
  site.release(site.id(kGoalDriver));
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(holders(kLaser), 0u);
  EXPECT_EQ(holders(kWheels), 1u);
}

TEST_P(AnyGoalTest, a_goal_for_a_closed_device_is_not_kept_for_the_next_who_opens_it) {
  site.release(site.id(kGoalDriver));
  EXPECT_EQ(go_to(0, 3), device::Taken::kNo);
  ASSERT_TRUE(site.hold(site.id(kGoalDriver)));
  site.run(2);
  EXPECT_EQ(told(), geom::Twist());
}

TEST_P(AnyGoalTest, at_its_goal_it_stands_and_leaves_the_robot_to_others) {
  go_to(0.1, 0);
  site.run(2);
  EXPECT_EQ(told(), geom::Twist());
  const std::vector<std::byte> turn = wire::encode(p2d::CmdVel{{0, 0, 0.5}, 1});
  site.driver(kWheels).command({site.id(kWheels), kCmd, p2d::kCmdVel, turn});
  site.run(40);
  EXPECT_EQ(told().a, 0.5);
  EXPECT_EQ(state().stall, 0);
}

TEST_P(AnyGoalTest, a_goal_beyond_its_numbers_is_refused_in_words) {
  EXPECT_EQ(go_to(1e300, 0), device::Taken::kNo);
  EXPECT_EQ(refusal(), "invalid goal: a pose within 1e9 m and 1e9 rad is valid");
  go_to(0, 3);
  EXPECT_EQ(refusal(), "");
}

TEST_P(AnyGoalTest, keeps_its_goal_when_the_run_is_taken_back) {
  go_to(0, 3);
  site.run(3);
  EXPECT_NE(told().a, 0);
  static_cast<Shell&>(driver()).rewound({1, 0.1, 1});
  world().positions.command[{0}] = {};
  EXPECT_EQ(told(), geom::Twist()) << "what was computed before is not said";
  site.run(2);
  EXPECT_DOUBLE_EQ(told().a, turn());
}

TEST_P(AnyGoalTest, has_no_goal_after_a_restart) {
  run::Simulation& simulation = *simulation_of(site.site());
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

TEST_P(AnyGoalTest, goals_may_come_in_every_tick) {
  for (int tick = 0; tick < 5; ++tick) {
    go_to(0, 3 + tick % 2);
    site.run(1);
  }
  EXPECT_GT(told().a, 0) << "they are to its left";
}

TEST_P(AnyGoalTest, requests_are_its_robot_s) {
  const auto answer = [this](std::uint8_t subtype, const std::vector<std::byte>& body) {
    driver().request({site.id(kGoalDriver), kReq, subtype, body}, device::Replier(site.recorder, subtype));
    site.run(0);
    return site.recorder.answers.at(subtype);
  };
  const auto geometry = wire::decode<p2d::Geom>(answer(p2d::kReqGetGeom, {}).body);
  ASSERT_TRUE(geometry);
  EXPECT_DOUBLE_EQ(geometry->size.sl, 0.4);
  EXPECT_TRUE(answer(p2d::kReqMotorPower, wire::encode(p2d::PowerConfig{0})).ack);
  EXPECT_EQ(world().positions.motor_on[{0}], 0);
  EXPECT_TRUE(answer(p2d::kReqSetOdom, wire::encode(p2d::SetOdomReq{{1, 2, 0}})).ack);
  EXPECT_TRUE(answer(p2d::kReqSpeedProf, wire::encode(p2d::SpeedProfReq{0.25f, 0})).ack);
  EXPECT_EQ(world().positions.speed_limit[{0}].x, 0.25);
  constexpr std::uint8_t kUnknown = 100;
  EXPECT_FALSE(answer(kUnknown, {}).ack);
  EXPECT_TRUE(driver().capable(site.id(kGoalDriver), kReq, p2d::kReqSetOdom));
  EXPECT_FALSE(driver().capable(site.id(kGoalDriver), kReq, kUnknown));
  EXPECT_TRUE(driver().capable(site.id(kGoalDriver), kCmd, p2d::kCmdPos));
}

TEST_P(AnyGoalTest, the_directory_shows_it_at_its_robot) {
  EXPECT_EQ(model_devices_of(site.site())->directory().model_of(kGoalDriver),
            model_devices_of(site.site())->directory().model_of(kWheels));
}

TEST_P(AnyGoalTest, ends_its_drive_when_it_hears_that_a_device_of_its_retired_and_lets_go_of_the_other) {
  ASSERT_TRUE(site.hold(site.id(kWheels))) << "by somebody else";
  go_to(0, 3);
  site.run(2);
  EXPECT_NE(told().a, 0);
  site.retire_device(site.id(kLaser));
  EXPECT_EQ(told(), geom::Twist());
  EXPECT_EQ(holders(kWheels), 1u);
  EXPECT_EQ(go_to(0, 3), device::Taken::kNo);
  site.release(site.id(kGoalDriver));  // has nothing left to let go of
  EXPECT_EQ(holders(kWheels), 1u);
}

}  // namespace
}  // namespace playhouse::drivers
