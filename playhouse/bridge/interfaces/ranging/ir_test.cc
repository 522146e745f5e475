// A ranger as interface ir, checked against the world's columns and the data sheet of a sensor.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/ir.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;
namespace ir = wire::ir;

class IrDevice : public testing::OneDevice {
 protected:
  IrDevice()
      : OneDevice(
            "interval_sim 100\nposition( name \"r0\" size [0.4 0.4 0.2] "
            "ranger( name \"ring\" pose [0.1 0 -0.2 0] "
            "sensor( pose [0 0.05 0 90] range [0.1 0.8] samples 2 ) "
            "sensor( pose [0 -0.05 0 -90] range [0.1 0.8] ) ) )") {
    open(ir::kCode, "r0.ring");
  }
  ir::Data data() { return last<ir::Data>(ir::kDataRanges); }
};

TEST_F(IrDevice, has_the_nearest_range_of_each_sensor_and_its_voltage) {
  measure("r0.ring", 0, {0.5f, 0.1f}, {1, 1});
  measure("r0.ring", 1, {0.8f}, {0});
  still_.run(1);
  EXPECT_THAT(data().ranges, ElementsAre(0.1f, 0.8f));
  // Read back as programs do: counts of 10 bits and 5 V, cm.
  const auto range = [](float volts) { return 6787 / (static_cast<double>(volts) * 1024 / 5 - 3) - 4; };
  ASSERT_EQ(data().voltages.size(), 2u);
  EXPECT_NEAR(range(data().voltages[0]), 10, 1e-4);
  EXPECT_NEAR(range(data().voltages[1]), 80, 1e-4);
  // The typical output that the data sheet draws.
  EXPECT_THAT(data().voltages, ElementsAre(FloatNear(2.4f, 0.1f), FloatNear(0.4f, 0.02f)));
}

TEST_F(IrDevice, tells_where_its_sensors_are_on_the_robot) {
  const auto poses = reply<ir::Pose>(ask(ir::kReqPose)).poses;
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_NEAR(poses[0].px, 0.1, 1e-12);
  EXPECT_NEAR(poses[0].py, 0.05, 1e-12);
  EXPECT_NEAR(poses[1].pyaw, -std::numbers::pi / 2, 1e-9);
}

TEST_F(IrDevice, is_silent_while_it_is_off_until_the_last_client_closes_it) {
  EXPECT_TRUE(ask_with(ir::kReqPower, ir::PowerReq{0}).ack);
  still_.run(2);
  EXPECT_EQ(count(ir::kDataRanges), 0);
  EXPECT_TRUE(ask_with(ir::kReqPower, ir::PowerReq{1}).ack);
  still_.run(1);
  EXPECT_EQ(count(ir::kDataRanges), 1);
  EXPECT_TRUE(ask_with(ir::kReqPower, ir::PowerReq{0}).ack);
  reopen();
  still_.run(1);
  EXPECT_EQ(count(ir::kDataRanges), 2);
  EXPECT_FALSE(ask(ir::kReqPower).ack) << "neither on nor off";
}

}  // namespace
}  // namespace playhouse::drivers
