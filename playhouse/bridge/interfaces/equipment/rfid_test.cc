// A reader of radio tags as a Player device, checked against the world's columns.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/rfid.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

using namespace std::string_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
namespace rfid = wire::rfid;

class RfidDevice : public testing::OneDevice {
 protected:
  RfidDevice()
      : OneDevice(
            "interval_sim 100\nposition( name \"r0\" rfid( name \"reader\" ) )\n"
            "model( name \"box\" rfid_tag \"E200 7f\" rfid_type 6 )\nmodel( name \"key\" rfid_tag \"0a\" )") {
    open(rfid::kCode, "r0.reader");
  }
  void sees(std::initializer_list<const char*> names) {
    std::vector<world::TagInRange>& tags = still_.world().rfids.tags[{0}];
    tags.clear();
    for (const char* name : names) tags.push_back({still_.world().id(still_.world().find(name)), 1});
  }
  std::vector<rfid::Tag> tags() {
    still_.run(1);
    return last<rfid::Data>(rfid::kDataTags).tags;
  }
};

TEST_F(RfidDevice, tells_the_type_and_the_bytes_of_each_tag) {
  sees({"box", "key"});
  EXPECT_THAT(tags(), ElementsAre(rfid::Tag{6, "\xe2\x00\x7f"s}, rfid::Tag{0, "\x0a"s}));
  sees({});
  EXPECT_THAT(tags(), IsEmpty());
}

TEST_F(RfidDevice, leaves_out_a_tag_whose_model_has_gone_since) {
  sees({"box", "key"});
  ASSERT_TRUE(world::despawn(still_.world(), still_.world().id(still_.world().find("box"))).ok());
  EXPECT_THAT(tags(), ElementsAre(rfid::Tag{0, "\x0a"s}));
}

TEST_F(RfidDevice, power_switches_over_and_can_be_set_by_name) {
  sees({"key"});
  EXPECT_TRUE(ask(rfid::kReqPower).ack);
  still_.run(3);
  EXPECT_EQ(count(rfid::kDataTags), 0);
  EXPECT_FALSE(ask(rfid::kReqReadtag).ack);
  EXPECT_TRUE(ask(rfid::kReqPower).ack);
  still_.run(1);
  EXPECT_EQ(count(rfid::kDataTags), 1);
  const auto set = [&](bool on) {
    return ask_with(wire::kReqSetBoolprop, wire::BoolpropReq{wire::c_string("power"), on}).ack;
  };
  EXPECT_TRUE(set(false));
  still_.run(1);
  EXPECT_EQ(count(rfid::kDataTags), 1);
  reopen();
  still_.run(1);
  EXPECT_EQ(count(rfid::kDataTags), 2) << "until the last client closes it";
}

TEST_F(RfidDevice, reading_is_confirmed_if_there_is_a_tag) {
  EXPECT_FALSE(ask(rfid::kReqReadtag).ack);
  sees({"key"});
  EXPECT_TRUE(ask(rfid::kReqReadtag).ack);
}

TEST_F(RfidDevice, writes_and_locks_nothing_as_no_request_says_what) {
  sees({"key"});
  EXPECT_FALSE(ask(rfid::kReqWritetag).ack);
  EXPECT_FALSE(ask(rfid::kReqLocktag).ack);
  EXPECT_THAT(tags(), ElementsAre(rfid::Tag{0, "\x0a"s}));
}

}  // namespace
}  // namespace playhouse::drivers
