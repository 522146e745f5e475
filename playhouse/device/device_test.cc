#include <gtest/gtest.h>

#include "playhouse/device/device_table.h"
#include "playhouse/device/properties.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"

namespace playhouse::device {
namespace {

constexpr std::uint8_t kReq = 3;

struct CountingDriver final : Driver {
  int starts = 0, stops = 0;
  bool broken = false;
  std::string_view name() const override { return "counting"; }
  Result<void> start(DeviceId, Receipt) override {
    if (broken) return Error{"", "no hardware"};
    ++starts;
    return {};
  }
  void stop(DeviceId, Receipt) override { ++stops; }
  bool command(const Message&) override { return true; }
  void request(const Message&, Replier) override {}
  bool capable(DeviceId, std::uint8_t, std::uint8_t) const override { return false; }
};

TEST(DeviceTable, lists_the_devices_of_a_port_in_order_of_creation) {
  CountingDriver driver;
  DeviceTable table;
  const DeviceId laser = *table.add({6665, 6, 0}, driver);
  const DeviceId other = *table.add({6666, 4, 0}, driver);
  const DeviceId wheels = *table.add({6665, 4, 0}, driver);
  ASSERT_EQ(table.devices_of(6665).size(), 2u);
  EXPECT_EQ(table.devices_of(6665)[0], laser);
  EXPECT_EQ(table.devices_of(6665)[1], wheels);
  EXPECT_EQ(table.find({6666, 4, 0}), other);
  EXPECT_FALSE(table.find({6666, 6, 0}).valid());
}

TEST(DeviceTable, refuses_a_second_device_at_an_address_and_the_server_s_own) {
  CountingDriver driver;
  DeviceTable table;
  ASSERT_TRUE(table.add({6665, 4, 0}, driver));
  const auto again = table.add({6665, 4, 0}, driver);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().line(), "6665:position2d:0: there is such a device already");
  EXPECT_FALSE(table.add({6665, 1, 0}, driver));
}

TEST(DeviceTable, starts_with_the_first_open_and_stops_with_the_last_close) {
  CountingDriver driver;
  DeviceTable table;
  const DeviceId id = *table.add({6665, 4, 0}, driver);
  ASSERT_TRUE(table.open(id));
  ASSERT_TRUE(table.open(id));
  EXPECT_EQ(driver.starts, 1);
  table.close(id);
  EXPECT_EQ(driver.stops, 0);
  table.close(id);
  EXPECT_EQ(driver.stops, 1);
}

TEST(DeviceTable, counts_no_user_for_a_device_that_did_not_start) {
  CountingDriver driver;
  DeviceTable table;
  const DeviceId id = *table.add({6665, 4, 0}, driver);
  driver.broken = true;
  EXPECT_FALSE(table.open(id));
  EXPECT_EQ(table[id].users, 0u);
  driver.broken = false;
  EXPECT_TRUE(table.open(id));
}

TEST(DeviceTable, stops_what_still_runs_when_it_goes) {
  CountingDriver driver;
  {
    DeviceTable table;
    ASSERT_TRUE(table.open(*table.add({6665, 4, 0}, driver)));
  }
  EXPECT_EQ(driver.stops, 1);
}

/// Keeps the answer to one request.
struct Answers final : Outlet {
  std::optional<bool> ack;
  std::vector<std::byte> body;
  void answer(std::uint64_t, bool positive, std::vector<std::byte> bytes) override {
    ack = positive;
    body = std::move(bytes);
  }
};

template <typename T>
Answers ask(PropertyBag& bag, std::uint8_t subtype, const T& request) {
  Answers answers;
  const std::vector<std::byte> body = wire::encode(request);
  bag.request({DeviceId{0}, kReq, subtype, body}, Replier(answers, 1));
  return answers;
}

TEST(PropertyBag, answers_get_with_the_value_and_set_with_an_empty_ack) {
  PropertyBag bag;
  bag.declare("skip_lines", 7);
  bag.declare("ip", std::string("127.0.0.1"));
  const wire::IntpropReq skip{wire::c_string("skip_lines"), 9};
  const Answers before = ask(bag, wire::kReqGetIntprop, skip);
  EXPECT_EQ(before.ack, true);
  EXPECT_EQ(wire::decode<wire::IntpropReq>(before.body)->value, 7);
  const Answers set = ask(bag, wire::kReqSetIntprop, skip);
  EXPECT_EQ(set.ack, true);
  EXPECT_TRUE(set.body.empty());
  EXPECT_EQ(bag.get("skip_lines"), PropertyValue(9));
  const Answers text = ask(bag, wire::kReqGetStrprop, wire::StrpropReq{wire::c_string("ip"), ""});
  EXPECT_EQ(wire::decode<wire::StrpropReq>(text.body)->value, wire::c_string("127.0.0.1"));
}

TEST(PropertyBag, refuses_an_unknown_key_another_type_and_a_read_only_property) {
  PropertyBag bag;
  bag.declare("rate", 0.5);
  bag.declare("serial", 4711, PropertyAccess::kReadOnly);
  EXPECT_EQ(ask(bag, wire::kReqGetIntprop, wire::IntpropReq{wire::c_string("nope"), 0}).ack, false);
  EXPECT_EQ(ask(bag, wire::kReqGetIntprop, wire::IntpropReq{wire::c_string("rate"), 0}).ack, false);
  EXPECT_EQ(ask(bag, wire::kReqSetIntprop, wire::IntpropReq{wire::c_string("serial"), 1}).ack, false);
  EXPECT_EQ(ask(bag, wire::kReqGetIntprop, wire::IntpropReq{wire::c_string("serial"), 0}).ack, true);
  EXPECT_EQ(bag.get("serial"), PropertyValue(4711));
  EXPECT_FALSE(bag.set("rate", 1));
  EXPECT_TRUE(bag.set("serial", 1));
}

TEST(Replier, answers_nack_when_it_is_dropped_and_once_only) {
  Answers answers;
  { const Replier dropped(answers, 1); }
  EXPECT_EQ(answers.ack, false);
  answers.ack.reset();
  {
    Replier replier(answers, 2);
    replier.ack();
    EXPECT_EQ(answers.ack, true);
    answers.ack.reset();
  }
  EXPECT_FALSE(answers.ack.has_value());
}

}  // namespace
}  // namespace playhouse::device
