// A robot that is told nothing for a while stops, by the time of its own data.

#include "playhouse/drivers/motion/deadstop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
namespace p2d = wire::position2d;

constexpr device::Address kWheels{6665, p2d::kCode, 0}, kGuarded{6665, p2d::kCode, 1};

class DeadStopTest : public ::testing::Test {
 protected:
  DeadStopTest()
      : bench(
            "driver( name \"deadstop\" provides [\"position2d:1\"] requires [\"position2d:0\"] timeout 0.5 )",
            {kWheels}, kGuarded) {}
  void pass(double time) { bench.says(kWheels, p2d::kDataState, time, p2d::Data{}); }
  device::Taken drive(double speed) { return bench.command(p2d::kCmdVel, p2d::CmdVel{{speed, 0, 0}, 1}); }
  /// Speeds that the wheels were told since the last call.
  std::vector<double> told() {
    std::vector<double> speeds;
    for (const p2d::CmdVel& command : bench.commanded<p2d::CmdVel>(kWheels, p2d::kCmdVel))
      speeds.push_back(command.vel.px);
    return speeds;
  }

  testing::DriverBench bench;
};

TEST_F(DeadStopTest, stops_the_robot_once_when_the_time_is_over) {
  pass(10);
  EXPECT_EQ(drive(0.3), device::Taken::kLatest);
  EXPECT_THAT(told(), ElementsAre(0.3));
  pass(10.1);  // from now on
  pass(10.59);
  EXPECT_THAT(told(), IsEmpty());
  pass(10.61);
  EXPECT_THAT(told(), ElementsAre(0));
  pass(11);
  EXPECT_THAT(told(), IsEmpty()) << "it stands";
}

TEST_F(DeadStopTest, goes_on_as_long_as_there_are_commands_and_after_a_stop) {
  for (int i = 0; i < 30; ++i) {
    if (i % 4 == 0) drive(0.3);
    pass(0.1 * i);
  }
  EXPECT_EQ(told(), std::vector<double>(8, 0.3));
  pass(10);
  EXPECT_THAT(told(), ElementsAre(0));
  EXPECT_EQ(drive(0.2), device::Taken::kLatest);
  pass(10.1);
  pass(10.3);
  EXPECT_THAT(told(), ElementsAre(0.2));
}

TEST_F(DeadStopTest, says_nothing_to_a_robot_that_stands) {
  pass(1);
  pass(9);
  drive(0);
  pass(10);
  pass(20);
  EXPECT_THAT(told(), ElementsAre(0));
}

TEST_F(DeadStopTest, stops_drives_to_goals_too) {
  pass(1);
  EXPECT_EQ(bench.command(p2d::kCmdPos, p2d::CmdPos{{3, 0, 0}, {}, 1}), device::Taken::kLatest);
  pass(1.1);
  pass(1.7);
  EXPECT_THAT(told(), ElementsAre(0));
}

TEST_F(DeadStopTest, a_time_that_goes_back_begins_anew) {
  pass(100);
  drive(0.3);
  pass(100.1);
  pass(5);
  pass(5.4);
  EXPECT_THAT(told(), ElementsAre(0.3));
  pass(5.5);
  EXPECT_THAT(told(), ElementsAre(0));
}

TEST_F(DeadStopTest, stops_the_robot_when_the_last_client_has_gone) {
  pass(1);
  drive(0.3);
  bench.close();
  EXPECT_THAT(told(), ElementsAre(0.3, 0));
}

TEST_F(DeadStopTest, passes_data_and_requests_on) {
  bench.says(kWheels, p2d::kDataState, 4, p2d::Data{{1, 2, 3}, {}, 1});
  EXPECT_EQ(bench.heard<p2d::Data>(p2d::kDataState).at(0).pos.py, 2);
  bench.answers(kWheels, p2d::kReqGetGeom, p2d::Geom{{}, {0.3, 0.5, 0.2}});
  EXPECT_EQ(wire::decode<p2d::Geom>(*bench.ask(p2d::kReqGetGeom))->size.sl, 0.5);
  EXPECT_FALSE(bench.ask(p2d::kReqResetOdom));
}

TEST(DeadStop, needs_a_timeout_that_is_one) {
  EXPECT_EQ(
      testing::fault_of(
          "driver( name \"dummy\" provides [\"position2d:0\"] )\n"
          "driver( name \"deadstop\" provides [\"position2d:1\"] requires [\"position2d:0\"] timeout -1 )"),
      "test.cfg:2: timeout is 0 at least");
}

}  // namespace
}  // namespace playhouse::drivers
