// What clients have models say, checked against the world's columns.

#include <gtest/gtest.h>

#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/wire/generated/speech.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

namespace speech = wire::speech;

constexpr const char* kWorld = R"(
position( name "r0" say "at the start" ranger( name "eye" ) )
model( name "box" )
)";

class SpeechDevice : public ::testing::Test {
 protected:
  void open(device::DeviceId id, const char* model) {
    driver_.add(id, make_device(still_.devices, speech::kCode, still_.world().find(model)));
    ASSERT_TRUE(driver_.start(id));
  }
  device::Taken say(device::DeviceId id, std::string_view text) {
    const std::vector<std::byte> body = wire::encode(speech::Cmd{wire::c_string(text)});
    return driver_.command({id, static_cast<std::uint8_t>(wire::MessageType::kCmd), speech::kCmdSay, body});
  }
  const std::string& said(const char* model) {
    still_.run(0);
    return still_.world().models.say[still_.world().find(model)];
  }

  static constexpr device::DeviceId kFirst{3}, kSecond{4};
  testing::StillDevices still_{kWorld};
  SimulatedDriver driver_{still_.devices, "stage"};
};

TEST_F(SpeechDevice, has_a_model_of_any_kind_say_the_newest_text) {
  open(kFirst, "r0.eye");
  open(kSecond, "box");
  EXPECT_EQ(say(kFirst, "one"), device::Taken::kQueued);
  say(kFirst, "two");
  say(kSecond, "I am a box");
  EXPECT_EQ(said("r0.eye"), "two");
  EXPECT_EQ(said("box"), "I am a box");
  EXPECT_EQ(said("r0"), "at the start") << "not the model around it";
}

TEST_F(SpeechDevice, an_empty_text_ends_what_was_said) {
  open(kFirst, "r0");
  say(kFirst, "");
  EXPECT_EQ(said("r0"), "");
}

TEST_F(SpeechDevice, what_is_said_stays_when_the_client_goes) {
  open(kFirst, "r0");
  say(kFirst, "gone for lunch");
  driver_.stop(kFirst);
  EXPECT_EQ(said("r0"), "gone for lunch");
}

TEST_F(SpeechDevice, several_devices_of_one_model_say_the_same) {
  open(kFirst, "r0");
  open(kSecond, "r0");
  say(kFirst, "a");
  say(kSecond, "b");
  EXPECT_EQ(said("r0"), "b");
}

TEST_F(SpeechDevice, says_what_is_no_line_of_text_as_one) {
  open(kFirst, "r0");
  say(kFirst, "a\nb\xff");
  EXPECT_EQ(said("r0"), "a b?");
}

TEST_F(SpeechDevice, drops_what_is_no_command) {
  open(kFirst, "r0");
  const std::byte cut[3] = {};
  EXPECT_EQ(
      driver_.command({kFirst, static_cast<std::uint8_t>(wire::MessageType::kCmd), speech::kCmdSay, cut}),
      device::Taken::kNo);
  EXPECT_EQ(said("r0"), "at the start");
}

TEST_F(SpeechDevice, what_a_model_that_has_gone_was_to_say_is_lost) {
  open(kFirst, "box");
  say(kFirst, "too late");
  ASSERT_TRUE(world::despawn(still_.world(), still_.world().id(still_.world().find("box"))).ok());
  still_.run(1);
  EXPECT_FALSE(still_.world().find("box").valid());
}

}  // namespace
}  // namespace playhouse::drivers
