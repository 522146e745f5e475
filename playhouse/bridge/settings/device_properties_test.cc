// Properties of simulated devices by name: settings, and words of the model.

#include "playhouse/bridge/settings/device_properties.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/fiducial.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

constexpr const char* kWorld = R"(
interval_sim 100
define robot position( size [0.4 0.3 0.2] drive "omni" obstacle_return 0 )
robot( name "r0" fiducial( name "finder" range_max 6 fov 90 ignore_zloc 1 ) )
)";

class DeviceProperties : public testing::OneDevice {
 protected:
  DeviceProperties() : OneDevice(kWorld) {}

  template <typename Request>
  std::optional<decltype(Request::value)> get(std::uint8_t subtype, const std::string& name) {
    const auto answer = ask_with(subtype, Request{wire::c_string(name), {}});
    if (!answer.ack) return std::nullopt;
    const Result<Request> value = wire::decode<Request>(answer.body);
    EXPECT_TRUE(value);
    EXPECT_EQ(wire::text(value->key), name);
    return value->value;
  }
  std::optional<std::string> text(const std::string& name) {
    const auto value = get<wire::StrpropReq>(wire::kReqGetStrprop, name);
    return value ? std::optional<std::string>(wire::text(*value)) : std::nullopt;
  }
};

TEST_F(DeviceProperties, the_words_of_the_model_are_as_its_file_says) {
  open(wire::fiducial::kCode, "r0.finder");
  EXPECT_EQ(number("range_max"), 6);
  EXPECT_EQ(number("range_max_id"), 5) << "the file is silent";
  EXPECT_EQ(number("fov"), 90) << "in degrees, as there";
  EXPECT_EQ(get<wire::BoolpropReq>(wire::kReqGetBoolprop, "ignore_zloc"), 1);
  EXPECT_EQ(get<wire::IntpropReq>(wire::kReqGetIntprop, "fov"), 90);
  EXPECT_EQ(text("name"), "r0.finder");
  EXPECT_EQ(text("model"), "fiducial");
  EXPECT_EQ(text("no such word"), std::nullopt);
  EXPECT_EQ(text("size"), "[0 0 0]") << "of every model";
  EXPECT_EQ(get<wire::BoolpropReq>(wire::kReqGetBoolprop, "range_max"), std::nullopt) << "no switch";
  EXPECT_FALSE(set_number("range_max", 3)) << "the model is what it is";
  EXPECT_EQ(number("range_max"), 6);
}

TEST_F(DeviceProperties, words_of_macros_and_choices_count) {
  open(wire::position2d::kCode, "r0");
  EXPECT_EQ(text("drive"), "omni");
  EXPECT_EQ(text("size"), "[0.4 0.3 0.2]");
  EXPECT_EQ(get<wire::BoolpropReq>(wire::kReqGetBoolprop, "obstacle_return"), 0);
}

TEST_F(DeviceProperties, settings_have_one_type_and_end_with_the_last_close) {
  open(wire::position2d::kCode, "r0");
  EXPECT_TRUE(ask_with(wire::position2d::kReqSpeedPid, wire::position2d::SpeedPidReq{0.5f, 0.25f, -1}).ack);
  EXPECT_EQ(number("speed_pid.kp"), 0.5);
  EXPECT_EQ(number("speed_pid.kd"), -1);
  EXPECT_EQ(number("position_pid.kp"), 0);
  EXPECT_TRUE(set_number("position_pid.kp", 2));
  EXPECT_EQ(number("position_pid.kp"), 2);
  EXPECT_FALSE(set_number("position_pid.kp", std::nan("")));
  EXPECT_FALSE(set_number("speed_pid.ki", std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(
      ask_with(wire::position2d::kReqPositionPid, wire::position2d::PositionPidReq{std::nanf(""), 0, 0}).ack);
  EXPECT_EQ(get<wire::IntpropReq>(wire::kReqGetIntprop, "position_pid.kp"), std::nullopt);
  EXPECT_FALSE(ask_with(wire::kReqSetIntprop, wire::IntpropReq{wire::c_string("position_pid.kp"), 3}).ack);
  EXPECT_TRUE(ask_with(wire::position2d::kReqVelocityMode, wire::position2d::VelocityModeConfig{1}).ack);
  reopen();
  EXPECT_EQ(number("position_pid.kp"), 0);
  EXPECT_TRUE(driver_.capable(kId, static_cast<std::uint8_t>(wire::MessageType::kReq), wire::kReqGetDblprop));
}

TEST_F(DeviceProperties, a_device_that_retires_answers_what_waits) {
  open(wire::fiducial::kCode, "r0.finder");
  driver_.request({kId, static_cast<std::uint8_t>(wire::MessageType::kReq), wire::kReqSetDblprop,
                   wire::encode(wire::DblpropReq{wire::c_string("view_angle"), 1})},
                  device::Replier(still_.recorder, 99));
  driver_.forget(kId);  // while the request waits
  still_.run(0);
  EXPECT_TRUE(still_.recorder.answers.at(99).ack) << "the device outlives it";
  EXPECT_FALSE(ask_with(wire::kReqGetDblprop, wire::DblpropReq{wire::c_string("view_angle"), 0}).ack);
}

}  // namespace
}  // namespace playhouse::drivers
