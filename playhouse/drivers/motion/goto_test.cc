// A robot that moves as it is told gets to its goals.

#include "playhouse/drivers/motion/goto.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/drivers/motion/differential.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/wire/generated/dio.h"

namespace playhouse::drivers {
namespace {

namespace p2d = wire::position2d;

constexpr device::Address kWheels{6665, p2d::kCode, 0}, kDriver{6665, p2d::kCode, 1},
    kDio{6665, wire::dio::kCode, 0};
constexpr double kPeriod = 0.1;  // s

TEST(GotoStep, turns_then_drives_then_turns) {
  const GotoOptions options;
  const GotoStep aside = goto_step(options, {}, {0, 3, 0, 0}, false);
  EXPECT_EQ(aside.speed, 0);
  EXPECT_DOUBLE_EQ(aside.turn_rate, geom::radians(45));
  EXPECT_DOUBLE_EQ(goto_step(options, {}, {3, -3, 0, 0}, false).turn_rate, geom::radians(-45));
  EXPECT_DOUBLE_EQ(goto_step(options, {}, {3, 0, 0, 0}, false).speed, 0.7);
  EXPECT_DOUBLE_EQ(goto_step(options, {}, {1, 0, 0, 0}, false).speed, 0.4);
  EXPECT_DOUBLE_EQ(goto_step(options, {}, {0.03, 0, 0, geom::radians(12.5)}, false).turn_rate,
                   geom::radians(27.5));
  EXPECT_TRUE(goto_step(options, {}, {0.03, 0, 0, geom::radians(2)}, false).done);
  EXPECT_TRUE(goto_step(options, {}, {0.1, 0, 0, geom::radians(2)}, true).done) << "it was there";
}

class GotoTest : public ::testing::Test {
 protected:
  GotoTest()
      : bench("driver( name \"goto\" provides [\"position2d:1\" \"dio:0\"] requires [\"position2d:0\"] )",
              {kWheels}, kDriver) {
    EXPECT_TRUE(bench.site().hold(bench.site().id(kDio)));
  }
  /// The robot says where it is, and moves as it was told last.
  void tick() {
    bench.says(kWheels, p2d::kDataState, kPeriod * static_cast<double>(++ticks_),
               p2d::Data{pose2d(X_OR), {}, 0});
    for (const p2d::CmdVel& told : bench.commanded<p2d::CmdVel>(kWheels, p2d::kCmdVel))
      velocity = {told.vel.px, 0, 0, told.vel.pa};
    X_OR = moved_along(X_OR, velocity, kPeriod);
  }
  std::uint32_t bits() { return bench.heard<wire::dio::Data>(kDio, wire::dio::kDataValues).back().bits; }

  testing::DriverBench bench;
  geom::Pose X_OR;
  geom::Twist velocity;
  int ticks_ = 0;
};

TEST_F(GotoTest, gets_to_goals_all_around) {
  for (const geom::Pose& goal : {geom::Pose{2, 1, 0, 1}, geom::Pose{-3, 0.5, 0, -3},
                                 geom::Pose{-3, 0.4, 0, 0}, geom::Pose{-3.02, 0.4, 0, 2}}) {
    EXPECT_EQ(bench.command(p2d::kCmdPos, p2d::CmdPos{pose2d(goal), {}, 1}), device::Taken::kLatest);
    tick();
    EXPECT_EQ(bits(), 0u);
    for (int i = 0; i < 300; ++i) tick();
    EXPECT_EQ(bits(), 1u);
    EXPECT_EQ(velocity, geom::Twist());
    EXPECT_LT(std::fabs(X_OR.x - goal.x), 0.05);
    EXPECT_LT(std::fabs(X_OR.y - goal.y), 0.05);
    EXPECT_LT(std::fabs(geom::normalize(X_OR.a - goal.a)), geom::radians(3.01));
  }
}

TEST_F(GotoTest, a_velocity_ends_the_drive) {
  bench.command(p2d::kCmdPos, p2d::CmdPos{{5, 0, 0}, {}, 1});
  tick();
  EXPECT_EQ(velocity.x, 0.7);
  bench.command(p2d::kCmdVel, p2d::CmdVel{{0.2, 0, 0}, 1});
  tick();
  tick();
  EXPECT_EQ(velocity.x, 0.2);
}

TEST(Goto, says_what_is_wrong_with_its_tolerances) {
  EXPECT_EQ(
      testing::fault_of(
          "driver( name \"dummy\" provides [\"position2d:0\"] )\n"
          "driver( name \"goto\" provides [\"position2d:1\"] requires [\"position2d:0\"] dist_tol -1 )"),
      "test.cfg:2: dist_tol is 0 at least");
}

}  // namespace
}  // namespace playhouse::drivers
