#include "playhouse/drivers/motion/bumper_safe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
namespace p2d = wire::position2d;
namespace bmp = wire::bumper;

constexpr device::Address kWheels{6665, p2d::kCode, 0}, kBumper{6665, bmp::kCode, 0},
    kGuarded{6665, p2d::kCode, 1};

class BumperSafeTest : public ::testing::Test {
 protected:
  BumperSafeTest()
      : bench(
            "driver( name \"bumper_safe\" provides [\"position2d:1\"] requires [\"position2d:0\" "
            "\"bumper:0\"] )",
            {kWheels, kBumper}, kGuarded) {
    bench.answers(kWheels, p2d::kReqMotorPower, p2d::PowerConfig{1});
  }
  void press(std::vector<std::uint8_t> pressed) {
    bench.says(kBumper, bmp::kDataState, 1, bmp::Data{pressed});
  }
  void power(std::uint8_t on) {
    EXPECT_TRUE(bench.ask(p2d::kReqMotorPower, wire::encode(p2d::PowerConfig{on})));
  }
  device::Taken drive(double speed) { return bench.command(p2d::kCmdVel, p2d::CmdVel{{speed, 0, 0}, 1}); }
  std::vector<double> told() {
    std::vector<double> speeds;
    for (const p2d::CmdVel& command : bench.commanded<p2d::CmdVel>(kWheels, p2d::kCmdVel))
      speeds.push_back(command.vel.px);
    return speeds;
  }

  testing::DriverBench bench;
};

TEST_F(BumperSafeTest, stops_at_a_touch_and_takes_no_command_until_it_is_over) {
  drive(0.3);
  press({0, 0});
  EXPECT_THAT(told(), ElementsAre(0.3));
  press({0, 1});
  EXPECT_THAT(told(), ElementsAre(0));
  EXPECT_EQ(drive(-0.3), device::Taken::kNo);
  EXPECT_EQ(bench.command(p2d::kCmdPos, p2d::CmdPos{{1, 0, 0}, {}, 1}), device::Taken::kNo);
  EXPECT_EQ(bench.command(p2d::kCmdCar, p2d::CmdCar{1, 0}), device::Taken::kNo);
  EXPECT_EQ(bench.command(p2d::kCmdVelHead, p2d::CmdVelHead{1, 0}), device::Taken::kNo);
  EXPECT_EQ(drive(0), device::Taken::kLatest) << "it may always stop";
  press({0, 0});
  EXPECT_EQ(drive(0.3), device::Taken::kLatest);
  EXPECT_THAT(told(), ElementsAre(0, 0.3));
}

TEST_F(BumperSafeTest, motors_that_are_switched_on_let_it_move_with_the_bumpers_pressed_then) {
  press({0, 1});
  power(0);
  EXPECT_EQ(drive(-0.3), device::Taken::kNo);
  power(1);
  EXPECT_EQ(drive(-0.3), device::Taken::kLatest);
  press({0, 1});
  EXPECT_THAT(told(), ElementsAre(-0.3));
  press({1, 1});
  EXPECT_THAT(told(), ElementsAre(0)) << "another bumper";
  power(1);
  EXPECT_EQ(drive(-0.3), device::Taken::kLatest);
  press({0, 0});
  press({1, 0});
  EXPECT_THAT(told(), ElementsAre(-0.3, 0)) << "it was released meanwhile";
}

TEST_F(BumperSafeTest, a_robot_without_bumpers_drives) {
  press({});
  EXPECT_EQ(drive(0.3), device::Taken::kLatest);
  EXPECT_THAT(told(), ElementsAre(0.3));
}

}  // namespace
}  // namespace playhouse::drivers
