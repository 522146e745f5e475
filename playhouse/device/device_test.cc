#include <gtest/gtest.h>

#include "playhouse/device/device_table.h"

namespace playhouse::device {
namespace {

struct CountingDriver final : Driver {
  int starts = 0, stops = 0;
  bool broken = false;
  std::string_view name() const override { return "counting"; }
  Result<void> start(DeviceId) override {
    if (broken) return Error{"", "no hardware"};
    ++starts;
    return {};
  }
  void stop(DeviceId) override { ++stops; }
  Taken command(const Message&) override { return Taken::kLatest; }
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

TEST(DeviceTable, names_the_nearest_device_to_one_that_is_missing) {
  CountingDriver driver;
  DeviceTable table;
  for (const Address address : {Address{6665, 6, 2}, {6665, 6, 5}, {6665, 4, 0}, {6666, 62, 1}})
    ASSERT_TRUE(table.add(address, driver));
  EXPECT_EQ(table.why_missing({6665, 6, 0}), "no such device, the nearest is 6665:laser:2");
  EXPECT_EQ(table.why_missing({6665, 6, 3}), "no such device, the nearest is 6665:laser:2");
  EXPECT_EQ(table.why_missing({6665, 6, 4}), "no such device, the nearest is 6665:laser:5");
  EXPECT_EQ(table.why_missing({6665, 6, 65535}), "no such device, the nearest is 6665:laser:5");
  EXPECT_EQ(table.why_missing({6665, 62, 1}), "no such device, the nearest is 6666:ranger:1");
  EXPECT_EQ(table.why_missing({6665, 10, 0}), "no such device, and none of its interface");
  EXPECT_EQ(DeviceTable().why_missing({6665, 6, 0}), "no such device, and none of its interface");
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

TEST(DeviceTable, a_device_that_retires_is_stopped_and_leaves_its_address_to_another_of_a_new_id) {
  CountingDriver driver, heir;
  DeviceTable table;
  const DeviceId first = *table.add({6665, 4, 0}, driver);
  const DeviceId old = *table.add({6665, 6, 0}, driver);
  const DeviceId last = *table.add({6665, 62, 0}, driver);
  ASSERT_TRUE(table.open(old));
  table.retire(old);
  EXPECT_EQ(driver.stops, 1);
  EXPECT_FALSE(table.has(old));
  EXPECT_FALSE(table.find({6665, 6, 0}).valid());
  EXPECT_EQ(table.size(), 2u);

  const DeviceId next = *table.add({6665, 6, 0}, heir);
  EXPECT_NE(next, old);
  EXPECT_FALSE(table.has(old));
  EXPECT_EQ(table[next].users, 0u);
  const std::vector<DeviceId> listed(table.devices_of(6665).begin(), table.devices_of(6665).end());
  EXPECT_EQ(listed, (std::vector{first, last, next}));
}

TEST(DeviceTable, does_not_stop_a_device_that_nobody_has_open_when_it_retires) {
  CountingDriver driver;
  DeviceTable table;
  table.retire(*table.add({6665, 4, 0}, driver));
  EXPECT_EQ(driver.stops, 0);
  EXPECT_TRUE(table.devices_of(6665).empty());
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
