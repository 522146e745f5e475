// What robots hear of what others say, as bytes of interface speech_recognition.

#include "playhouse/wire/generated/speech_recognition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

namespace heard = wire::speech_recognition;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kWorld = R"(
position( name "r0" ranger( name "eye" ) )
position( name "ann" say "at the start" )
model( name "box" )
)";

class SpeechRecognitionDevice : public ::testing::Test {
 protected:
  SpeechRecognitionDevice() {
    driver_.add(kId, make_device(still_.devices, heard::kCode, still_.world().find("r0")));
  }
  void open() {
    ASSERT_TRUE(driver_.start(kId));
    still_.run(0);
  }
  void say(const char* model, std::string_view text) {
    world::set_say(still_.world(), still_.world().find(model), text);
  }
  /// In one tick.
  std::vector<std::string> heard_now() {
    still_.recorder.published.clear();
    still_.run(1);
    std::vector<std::string> all;
    for (const device::Publication& each : still_.recorder.published) {
      EXPECT_EQ(each.subtype, heard::kDataString);
      const auto data = wire::decode<heard::Data>(each.body);
      all.push_back(data ? data->text : "no message");
    }
    return all;
  }
  static std::string c(std::string_view text) { return wire::c_string(text); }

  static constexpr device::DeviceId kId{3};
  testing::StillDevices still_{kWorld};
  SimulatedDriver driver_{still_.devices, "stage"};
};

TEST_F(SpeechRecognitionDevice, hears_each_text_once_in_the_order_of_saying) {
  open();
  say("ann", "one");
  say("box", "two");
  say("ann", "three");
  EXPECT_THAT(heard_now(), ElementsAre(c("one"), c("two"), c("three")));
  EXPECT_THAT(heard_now(), IsEmpty());
  say("ann", "four");
  EXPECT_THAT(heard_now(), ElementsAre(c("four")));
}

TEST_F(SpeechRecognitionDevice, hears_what_is_said_in_the_tick_that_opens_it) {
  ASSERT_TRUE(driver_.start(kId));
  still_.run(0);
  say("ann", "at once");
  EXPECT_THAT(heard_now(), ElementsAre(c("at once")));
}

TEST_F(SpeechRecognitionDevice, does_not_hear_what_was_said_while_it_was_closed) {
  say("ann", "before");
  open();
  EXPECT_THAT(heard_now(), IsEmpty());
  driver_.stop(kId);
  still_.run(0);
  say("ann", "meanwhile");
  open();
  EXPECT_THAT(heard_now(), IsEmpty());
}

TEST_F(SpeechRecognitionDevice, does_not_hear_itself_or_what_it_carries) {
  open();
  say("r0", "me");
  say("r0.eye", "me, too");
  EXPECT_THAT(heard_now(), IsEmpty());
}

TEST_F(SpeechRecognitionDevice, silence_and_what_is_said_already_are_no_texts) {
  open();
  say("ann", "at the start");
  say("ann", "");
  EXPECT_THAT(heard_now(), IsEmpty());
}

TEST_F(SpeechRecognitionDevice, hears_who_has_gone_since) {
  open();
  say("box", "farewell");
  ASSERT_TRUE(world::despawn(still_.world(), still_.world().id(still_.world().find("box"))).ok());
  EXPECT_THAT(heard_now(), ElementsAre(c("farewell")));
}

TEST_F(SpeechRecognitionDevice, hears_the_newest_of_too_many) {
  open();
  for (std::size_t i = 0; i <= limits::kUtterances; ++i) say("ann", std::to_string(i));
  const std::vector<std::string> all = heard_now();
  ASSERT_EQ(all.size(), limits::kUtterances);
  EXPECT_EQ(all.front(), c("1"));
}

TEST_F(SpeechRecognitionDevice, hears_again_what_is_said_again_after_the_run_was_taken_back) {
  still_.simulation.requests().record(true);
  open();
  still_.run(1);
  const std::uint64_t instant = still_.world().tick();
  say("ann", "once");
  EXPECT_THAT(heard_now(), ElementsAre(c("once")));
  run::testing::rewind_to(still_.simulation, instant);
  EXPECT_THAT(heard_now(), IsEmpty());
  say("ann", "once");
  EXPECT_THAT(heard_now(), ElementsAre(c("once")));
}

}  // namespace
}  // namespace playhouse::drivers
