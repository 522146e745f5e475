// Two wheels as a robot: velocities and poses by the closed forms of differential drive.

#include "playhouse/drivers/motion/differential.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/geom/trig.h"

namespace playhouse::drivers {
namespace {

using ::testing::HasSubstr;
namespace p1d = wire::position1d;
namespace p2d = wire::position2d;

constexpr device::Address kLeft{6665, p1d::kCode, 0}, kRight{6665, p1d::kCode, 1},
    kRobot{6665, p2d::kCode, 0};

TEST(DifferentialKinematics, is_the_mean_and_the_difference_of_the_wheels) {
  const geom::Twist body = body_velocity({0.2, 0.6}, 0.5);
  EXPECT_DOUBLE_EQ(body.x, 0.4);
  EXPECT_DOUBLE_EQ(body.a, 0.8);
  const WheelSpeeds wheels = wheel_speeds({0.4, 0, 0, 0.8}, 0.5);
  EXPECT_DOUBLE_EQ(wheels.left, 0.2);
  EXPECT_DOUBLE_EQ(wheels.right, 0.6);
}

TEST(DifferentialKinematics, moves_along_lines_and_circles) {
  const geom::Pose ahead = moved_along({1, 2, 0, geom::radians(90)}, {0.5, 0, 0, 0}, 4);
  EXPECT_NEAR(ahead.x, 1, 1e-12);
  EXPECT_NEAR(ahead.y, 4, 1e-12);
  // A quarter of a circle of radius 2 to the left, from the origin, ends at (2, 2).
  const geom::Pose quarter = moved_along({}, {1, 0, 0, 0.5}, geom::kPi);
  EXPECT_NEAR(quarter.x, 2, 1e-12);
  EXPECT_NEAR(quarter.y, 2, 1e-12);
  EXPECT_NEAR(quarter.a, geom::radians(90), 1e-12);
  const geom::Pose full = moved_along({3, 4, 0, 1}, {1, 0, 0, -0.5}, 4 * geom::kPi);
  EXPECT_NEAR(full.x, 3, 1e-9);
  EXPECT_NEAR(full.y, 4, 1e-9);
  EXPECT_NEAR(full.a, 1, 1e-9);
}

class DifferentialTest : public ::testing::Test {
 protected:
  DifferentialTest()
      : bench(
            "driver( name \"differential\" provides [\"position2d:0\"] "
            "requires [\"right:::position1d:1\" \"left:::position1d:0\"] axis_length 0.5 )",
            {kLeft, kRight}, kRobot) {}
  void turn(device::Address wheel, double time, float speed, std::uint8_t stall = 0) {
    bench.says(wheel, p1d::kDataState, time, p1d::Data{0, speed, stall, 0});
  }
  p2d::Data state() { return bench.heard<p2d::Data>(p2d::kDataState).back(); }

  testing::DriverBench bench;
};

TEST_F(DifferentialTest, tells_each_wheel_its_speed) {
  EXPECT_EQ(bench.command(p2d::kCmdVel, p2d::CmdVel{{0.4, 0, 0.8}, 1}), device::Taken::kLatest);
  const auto& told = bench.told().commands;
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(wire::decode<p1d::CmdVel>(told[0].body)->vel, 0.2f);
  EXPECT_EQ(wire::decode<p1d::CmdVel>(told[1].body)->vel, 0.6f);
  EXPECT_EQ(told[1].device, bench.site().id(kRight));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(bench.command(p2d::kCmdVel, p2d::CmdVel{{kNan, 0, 0}, 1}), device::Taken::kNo);
  EXPECT_EQ(bench.command(p2d::kCmdPos, p2d::CmdPos{{1, 0, 0}, {}, 1}), device::Taken::kNo);
  bench.close();
  EXPECT_EQ(wire::decode<p1d::CmdVel>(told.back().body)->vel, 0) << "nobody drives it any more";
}

TEST_F(DifferentialTest, has_the_pose_of_the_speeds_over_their_time) {
  turn(kLeft, 1, 0.75f);
  turn(kRight, 1, 1.25f);  // 1 m/s and 1 rad/s: a circle of 1 m
  EXPECT_DOUBLE_EQ(state().vel.pa, 1);
  turn(kLeft, 1 + geom::kPi / 2, 0.75f);
  const p2d::Data quarter = state();
  EXPECT_NEAR(quarter.pos.px, 1, 1e-9);
  EXPECT_NEAR(quarter.pos.py, 1, 1e-9);
  EXPECT_NEAR(quarter.pos.pa, geom::radians(90), 1e-9);
  turn(kRight, 0, 0.75f);  // back in time
  EXPECT_NEAR(state().pos.py, 1, 1e-9);
  turn(kLeft, 2, 0.75f, 1);
  const p2d::Data ahead = state();
  EXPECT_NEAR(ahead.pos.py, 1 + 0.75 * 2, 1e-9);
  EXPECT_EQ(ahead.stall, 1);
}

TEST_F(DifferentialTest, sets_its_pose_and_switches_both_motors) {
  EXPECT_TRUE(bench.ask(p2d::kReqSetOdom, wire::encode(p2d::SetOdomReq{{1, 2, 0}})));
  turn(kLeft, 1, 0);
  EXPECT_EQ(state().pos.py, 2);
  EXPECT_TRUE(bench.ask(p2d::kReqResetOdom));
  turn(kLeft, 2, std::numeric_limits<float>::infinity());
  turn(kLeft, 2, 0);
  EXPECT_EQ(state().pos, wire::Pose2d{});
  const std::vector<std::byte> on = wire::encode(p2d::PowerConfig{1});
  bench.answers(kLeft, p1d::kReqMotorPower, p1d::PowerConfig{1});
  EXPECT_FALSE(bench.ask(p2d::kReqMotorPower, on)) << "the right one cannot";
  bench.answers(kRight, p1d::kReqMotorPower, p1d::PowerConfig{1});
  EXPECT_TRUE(bench.ask(p2d::kReqMotorPower, on));
  EXPECT_EQ(wire::decode<p2d::Geom>(*bench.ask(p2d::kReqGetGeom))->size.sw, 0.5);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(bench.ask(p2d::kReqSetOdom, wire::encode(p2d::SetOdomReq{{kNan, 2, 0}})));
}

TEST(Differential, needs_two_wheels_apart) {
  EXPECT_THAT(testing::fault_of("driver( name \"differential\" provides [\"position2d:0\"] requires "
                                "[\"position1d:0\" \"position1d:1\"] )"),
              HasSubstr("requires one position1d of key left and one position1d of key right"));
  EXPECT_EQ(testing::fault_of(
                "driver( name \"dummy\" provides [\"position1d:0\" \"position1d:1\"] )\n"
                "driver( name \"differential\" provides [\"position2d:0\"] requires [\"left:::position1d:0\" "
                "\"right:::position1d:1\"] axis_length 0 )"),
            "test.cfg:2: axis_length is 0.001 at least");
}

}  // namespace
}  // namespace playhouse::drivers
