#include "playhouse/drivers/motion/suppressor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
namespace p2d = wire::position2d;

constexpr device::Address kWheels{6665, p2d::kCode, 0}, kMaster{6665, p2d::kCode, 10},
    kSlave{6665, p2d::kCode, 11};

TEST(Suppressor, drops_commands_of_the_slave_for_a_while_after_one_of_the_master) {
  testing::DriverBench bench(
      "driver( name \"suppressor\" provides [\"master:::position2d:10\" \"slave:::position2d:11\"] "
      "requires [\"position2d:0\"] fadeout_time 0.5 )",
      {kWheels}, kMaster);
  const auto drive = [&bench](device::Address from, double speed) {
    EXPECT_EQ(bench.command(from, p2d::kCmdVel, p2d::CmdVel{{speed, 0, 0}, 1}), device::Taken::kLatest);
  };
  const auto pass = [&bench](double time) {
    bench.says(kWheels, p2d::kDataState, time, p2d::Data{{time, 0, 0}, {}, 0});
  };
  pass(1);
  drive(kSlave, 0.1);
  drive(kMaster, 0.2);
  drive(kSlave, 0.3);
  pass(1.4);
  drive(kSlave, 0.4);
  pass(1.5);
  drive(kSlave, 0.5);
  drive(kMaster, 0.6);
  pass(0.2);  // back
  drive(kSlave, 0.7);
  pass(0.8);
  drive(kSlave, 0.8);
  std::vector<double> speeds;
  for (const p2d::CmdVel& told : bench.commanded<p2d::CmdVel>(kWheels, p2d::kCmdVel))
    speeds.push_back(told.vel.px);
  EXPECT_THAT(speeds, ElementsAre(0.1, 0.2, 0.5, 0.6, 0.8));
  pass(2);
  EXPECT_EQ(bench.heard<p2d::Data>(kMaster, p2d::kDataState).back().pos.px, 2);
  pass(3);
  EXPECT_EQ(bench.heard<p2d::Data>(kSlave, p2d::kDataState).back().pos.px, 3);
  bench.answers(kWheels, p2d::kReqGetGeom, p2d::Geom{});
  EXPECT_TRUE(bench.ask(kMaster, p2d::kReqGetGeom));
  EXPECT_TRUE(bench.ask(kSlave, p2d::kReqGetGeom));
}

TEST(Suppressor, is_no_way_round_the_rights_to_manage_a_run) {
  EXPECT_EQ(testing::fault_of(
                "driver( name \"suppressor\" provides [\"master:::simulation:1\" \"slave:::simulation:2\"] "
                "requires [\"simulation:0\"] )"),
            "test.cfg:1: driver \"suppressor\" is not for devices of simulation");
}

}  // namespace
}  // namespace playhouse::drivers
