// Actuators as Player devices, checked against the world's columns.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/wire/generated/actarray.h"

namespace playhouse::drivers {
namespace {

namespace act = wire::actarray;
using wire::MessageType;
using world::ControlMode;

constexpr const char* kWorld = R"(
interval_sim 100
position( size [0.4 0.4 0.2]
  model( pose [0.1 0.2 0 90] size [0.1 0.1 0.1]
    actuator( pose [0.3 0 0 0] axis [0 0 3] min_position -1 max_position 2 max_speed 0.5 start_position 0.25
              update_interval 200 ) ) )
)";

/// The lift of kWorld, open.
class ActarrayDevice : public ::testing::Test {
 protected:
  ActarrayDevice() : still_(kWorld), driver_(still_.devices, "stage") {
    driver_.add(kId, make_device(still_.devices, act::kCode, {2}));
    EXPECT_TRUE(driver_.start(kId));
    still_.run(0);
  }

  world::Actuators& lifts() { return still_.world().actuators; }
  template <typename Payload>
  device::Taken command(std::uint8_t subtype, const Payload& payload) {
    const std::vector<std::byte> body = wire::encode(payload);
    const device::Taken taken =
        driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), subtype, body});
    still_.run(0);
    return taken;
  }
  bool ask(std::uint8_t subtype, const std::vector<std::byte>& body = {}) {
    driver_.request({kId, static_cast<std::uint8_t>(MessageType::kReq), subtype, body},
                    device::Replier(still_.recorder, ++ticket_));
    still_.run(0);
    return still_.recorder.answers.at(ticket_).ack;
  }
  act::Data newest() {
    EXPECT_FALSE(still_.recorder.published.empty());
    return *wire::decode<act::Data>(still_.recorder.published.back().body);
  }

  static constexpr device::DeviceId kId{3};
  testing::StillDevices still_;
  SimulatedDriver driver_;
  std::uint64_t ticket_ = 0;
};

TEST_F(ActarrayDevice, tells_where_it_is_and_what_it_does_at_its_own_interval) {
  still_.run(4);
  ASSERT_EQ(still_.recorder.published.size(), 2u);
  EXPECT_EQ(newest(), (act::Data{{{0.25f, 0, 0, -1, act::kActstateIdle}}, 1}));
  lifts().velocity[{0}] = 0.5;
  still_.run(2);
  EXPECT_EQ(newest(), (act::Data{{{0.25f, 0.5f, 0, -1, act::kActstateMoving}}, 1}));
  lifts().stall[{0}] = 1;
  still_.run(2);
  EXPECT_EQ(newest(), (act::Data{{{0.25f, 0, 0, -1, act::kActstateStalled}}, 1}));
}

TEST_F(ActarrayDevice, has_a_geometry_on_the_robot) {
  ASSERT_TRUE(ask(act::kReqGetGeom));
  const auto geom = wire::decode<act::Geom>(still_.recorder.answers.at(ticket_).body);
  ASSERT_TRUE(geom);
  ASSERT_EQ(geom->actuators.size(), 1u);
  const act::Actuatorgeom& joint = geom->actuators[0];
  EXPECT_EQ(joint.type, act::kTypeLinear);
  EXPECT_EQ(joint.axis, (wire::Point3d{0, 0, 1}));
  EXPECT_EQ(joint.min, -1);
  EXPECT_EQ(joint.centre, 0.5f);
  EXPECT_EQ(joint.max, 2);
  EXPECT_EQ(joint.home, 0.25f);
  EXPECT_EQ(joint.config_speed, 0.5f);
  EXPECT_NEAR(geom->base_pos.px, 0.1, 1e-12);
  EXPECT_NEAR(geom->base_pos.py, 0.5, 1e-12);
  EXPECT_NEAR(geom->base_pos.pz, 0.3, 1e-12) << "at position 0, on the model on the robot";
}

TEST_F(ActarrayDevice, goes_where_it_is_told_at_the_speed_that_it_is_told) {
  EXPECT_EQ(command(act::kCmdPos, act::PositionCmd{0, 7}), device::Taken::kLatest);
  EXPECT_EQ(lifts().mode[{0}], ControlMode::kPosition);
  EXPECT_EQ(lifts().goal[{0}], 2) << "its end";
  EXPECT_EQ(command(act::kCmdMultiPos, act::MultiPositionCmd{{-0.5f}}), device::Taken::kLatest);
  EXPECT_EQ(lifts().goal[{0}], -0.5);
  EXPECT_EQ(command(act::kCmdHome, act::HomeCmd{-1}), device::Taken::kLatest);
  EXPECT_EQ(lifts().goal[{0}], 0.25);
  EXPECT_EQ(command(act::kCmdSpeed, act::SpeedCmd{0, -0.25f}), device::Taken::kLatest);
  EXPECT_EQ(lifts().mode[{0}], ControlMode::kVelocity);
  EXPECT_EQ(lifts().command[{0}], -0.25);
  EXPECT_EQ(command(act::kCmdMultiSpeed, act::MultiSpeedCmd{{0.125f}}), device::Taken::kLatest);
  EXPECT_EQ(lifts().command[{0}], 0.125);
  EXPECT_TRUE(ask(act::kReqSpeed, wire::encode(act::SpeedConfig{-1, 0.25f})));
  EXPECT_EQ(lifts().speed[{0}], 0.25);
}

TEST_F(ActarrayDevice, has_power_and_brakes_until_the_last_client_closes_it) {
  EXPECT_TRUE(ask(act::kReqPower, wire::encode(act::PowerConfig{0})));
  EXPECT_TRUE(ask(act::kReqBrakes, wire::encode(act::BrakesConfig{1})));
  EXPECT_EQ(lifts().motor_on[{0}], 0);
  EXPECT_EQ(lifts().braked[{0}], 1);
  still_.run(2);
  EXPECT_EQ(newest().motor_state, 0);
  EXPECT_EQ(newest().actuators[0].state, act::kActstateBraked);
  EXPECT_TRUE(ask(act::kReqSpeed, wire::encode(act::SpeedConfig{0, 0.1f})));
  command(act::kCmdSpeed, act::SpeedCmd{0, 0.5f});
  driver_.stop(kId);
  still_.run(0);
  EXPECT_EQ(lifts().motor_on[{0}], 1);
  EXPECT_EQ(lifts().braked[{0}], 0);
  EXPECT_EQ(lifts().speed[{0}], 0.5);
  EXPECT_EQ(lifts().command[{0}], 0);
}

TEST_F(ActarrayDevice, has_an_acceleration_until_the_last_client_closes_it) {
  EXPECT_TRUE(ask(act::kReqAccel, wire::encode(act::AccelConfig{-1, 0.25f})));
  EXPECT_EQ(lifts().acceleration[{0}], 0.25);
  driver_.stop(kId);
  still_.run(0);
  EXPECT_EQ(lifts().acceleration[{0}], 0);
}

TEST_F(ActarrayDevice, refuses_other_joints_and_what_makes_no_sense) {
  const float nan = std::nanf("");
  EXPECT_EQ(command(act::kCmdPos, act::PositionCmd{1, 0}), device::Taken::kNo);
  EXPECT_EQ(command(act::kCmdPos, act::PositionCmd{0, nan}), device::Taken::kNo);
  EXPECT_EQ(command(act::kCmdMultiPos, act::MultiPositionCmd{{1, 2}}), device::Taken::kNo);
  EXPECT_EQ(command(act::kCmdSpeed, act::SpeedCmd{-2, 0}), device::Taken::kNo);
  EXPECT_EQ(command(act::kCmdSpeed, act::SpeedCmd{0, std::numeric_limits<float>::infinity()}),
            device::Taken::kNo);
  EXPECT_EQ(command(act::kCmdMultiSpeed, act::MultiSpeedCmd{}), device::Taken::kNo);
  EXPECT_EQ(command(act::kCmdHome, act::HomeCmd{2}), device::Taken::kNo);
  EXPECT_FALSE(ask(act::kReqSpeed, wire::encode(act::SpeedConfig{1, 0.1f})));
  EXPECT_FALSE(ask(act::kReqSpeed, wire::encode(act::SpeedConfig{0, 0.6f}))) << "faster than it can";
  EXPECT_FALSE(ask(act::kReqSpeed, wire::encode(act::SpeedConfig{0, nan})));
  EXPECT_FALSE(ask(act::kReqAccel, wire::encode(act::AccelConfig{1, 0.1f})));
  EXPECT_FALSE(ask(act::kReqAccel, wire::encode(act::AccelConfig{0, -0.1f})));
  EXPECT_FALSE(ask(act::kReqAccel, wire::encode(act::AccelConfig{0, nan})));
  EXPECT_FALSE(ask(act::kReqPower));
  EXPECT_EQ(lifts().command[{0}], 0);
}

}  // namespace
}  // namespace playhouse::drivers
