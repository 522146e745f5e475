#include "playhouse/drivers/localbb/local_blackboard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/blackboard.h"

namespace playhouse::drivers {
namespace {

namespace blackboard = wire::blackboard;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kSection = "driver( name \"localbb\" provides [\"blackboard:0\"] )";
constexpr std::uint8_t kRequest = 3;

wire::BlackboardEntry entry(std::string_view group, std::string_view key,
                            std::vector<std::uint8_t> data = {}) {
  return {wire::c_string(key), wire::c_string(group), 1, 2, std::move(data), 0, 0};
}

class Blackboard : public ::testing::Test {
 protected:
  Blackboard() { EXPECT_EQ(site.build(kSection), ""); }

  /// True if it is answered ACK; its value, if it has one, is `value`.
  bool ask(device::Caller* caller, std::uint8_t subtype, const wire::BlackboardEntry& about) {
    const std::vector<std::byte> body = wire::encode(about);
    ++ticket;
    site.driver(board).request({site.id(board), kRequest, subtype, body, caller},
                               device::Replier(site.recorder, ticket));
    site.hear();
    const testing::OutputRecorder::RecordedAnswer& answer = site.recorder.answers.at(ticket);
    if (!answer.body.empty()) value = *wire::decode<wire::BlackboardEntry>(answer.body);
    return answer.ack;
  }
  bool set(std::string_view group, std::string_view key, std::vector<std::uint8_t> data) {
    return ask(&one, blackboard::kReqSetEntry, entry(group, key, std::move(data)));
  }
  /// "group/key=first byte>clients" of what was published; clears it.
  std::vector<std::string> updates() {
    std::vector<std::string> lines;
    for (const device::Publication& publication : std::exchange(site.recorder.published, {})) {
      EXPECT_EQ(publication.device, site.id(board));
      EXPECT_EQ(publication.subtype, blackboard::kDataUpdate);
      const auto told = *wire::decode<wire::BlackboardEntry>(publication.body);
      std::string line = std::string(wire::text(told.group)) + "/" + std::string(wire::text(told.key)) + "=" +
                         std::to_string(told.data.empty() ? -1 : told.data[0]) + ">";
      for (const std::uint32_t client : publication.clients) line += " " + std::to_string(client);
      lines.push_back(line);
    }
    return lines;
  }

  const device::Address board{6665, blackboard::kCode, 0};
  testing::MemorySite site{""};
  device::Caller one{"one", 1}, two{"two", 2}, three{"three", 3};
  std::uint64_t ticket = 0;
  wire::BlackboardEntry value;
};

TEST_F(Blackboard, keeps_the_newest_value_of_each_key_in_its_group) {
  EXPECT_TRUE(set("a", "k", {1}));
  EXPECT_TRUE(set("b", "k", {2}));
  EXPECT_TRUE(set("a", "k", {3, 4}));
  EXPECT_TRUE(ask(&two, blackboard::kReqGetEntry, entry("a", "k")));
  EXPECT_EQ(value.key, wire::c_string("k"));
  EXPECT_EQ(value.group, wire::c_string("a"));
  EXPECT_EQ(value.type, 1);
  EXPECT_EQ(value.subtype, 2);
  EXPECT_THAT(value.data, ElementsAre(3, 4));
  EXPECT_TRUE(ask(&two, blackboard::kReqGetEntry, entry("b", "k")));
  EXPECT_THAT(value.data, ElementsAre(2));
}

TEST_F(Blackboard, answers_for_an_entry_that_is_not_there_with_an_empty_one) {
  for (const std::uint8_t asked : {blackboard::kReqGetEntry, blackboard::kReqSubscribeToKey}) {
    EXPECT_TRUE(ask(&one, asked, entry("a", "k", {9})));
    EXPECT_EQ(value, (wire::BlackboardEntry{wire::c_string("k"), wire::c_string("a"), 0, 0, {}, 0, 0}));
  }
}

TEST_F(Blackboard, keeps_the_time_of_the_writer_or_sets_its_own) {
  wire::BlackboardEntry written = entry("a", "k", {1});
  written.timestamp_usec = 7;
  EXPECT_TRUE(ask(&one, blackboard::kReqSetEntry, written));
  EXPECT_TRUE(ask(&one, blackboard::kReqGetEntry, written));
  EXPECT_EQ(value.timestamp_sec, 0u);
  EXPECT_EQ(value.timestamp_usec, 7u);
  const double before = site.site().time();
  EXPECT_TRUE(set("a", "k", {1}));
  EXPECT_TRUE(ask(&one, blackboard::kReqGetEntry, written));
  const double at = value.timestamp_sec + 1e-6 * value.timestamp_usec;
  EXPECT_GE(at, before - 1e-5);
  EXPECT_LE(at, site.site().time() + 1e-5);
}

TEST_F(Blackboard, tells_of_a_key_those_who_subscribed_to_it_and_gives_them_its_value_at_once) {
  EXPECT_TRUE(set("a", "k", {1}));
  EXPECT_THAT(updates(), IsEmpty());
  EXPECT_TRUE(ask(&two, blackboard::kReqSubscribeToKey, entry("a", "k")));
  EXPECT_THAT(value.data, ElementsAre(1));
  EXPECT_TRUE(ask(&three, blackboard::kReqSubscribeToKey, entry("a", "other")));
  EXPECT_TRUE(set("a", "k", {2}));
  EXPECT_TRUE(set("a", "other", {3}));
  EXPECT_TRUE(set("b", "k", {4}));
  EXPECT_THAT(updates(), ElementsAre("a/k=2> 2", "a/other=3> 3"));
  EXPECT_TRUE(ask(&two, blackboard::kReqUnsubscribeFromKey, entry("a", "k")));
  EXPECT_TRUE(set("a", "k", {5}));
  EXPECT_THAT(updates(), IsEmpty());
}

TEST_F(Blackboard, tells_all_of_a_group_to_those_who_subscribed_to_it) {
  EXPECT_TRUE(set("a", "k", {1}));
  EXPECT_TRUE(set("a", "l", {2}));
  EXPECT_TRUE(set("ab", "k", {3}));
  EXPECT_TRUE(ask(&two, blackboard::kReqSubscribeToGroup, entry("a", "")));
  EXPECT_THAT(updates(), ElementsAre("a/k=1> 2", "a/l=2> 2"));
  EXPECT_TRUE(ask(&one, blackboard::kReqSubscribeToKey, entry("a", "k")));
  EXPECT_TRUE(ask(&two, blackboard::kReqSubscribeToKey, entry("a", "k")));
  EXPECT_TRUE(set("a", "k", {4}));
  EXPECT_TRUE(set("a", "new", {5}));
  EXPECT_THAT(updates(), ElementsAre("a/k=4> 1 2", "a/new=5> 2")) << "once, although two subscribed twice";
  EXPECT_TRUE(ask(&two, blackboard::kReqUnsubscribeFromGroup, entry("a", "")));
  EXPECT_TRUE(set("a", "k", {6}));
  EXPECT_TRUE(set("a", "new", {7}));
  EXPECT_THAT(updates(), ElementsAre("a/k=6> 1 2")) << "a key that was subscribed to by itself remains";
}

TEST_F(Blackboard, forgets_a_client_that_goes) {
  {
    device::Caller guest("guest", 9);
    EXPECT_TRUE(ask(&guest, blackboard::kReqSubscribeToKey, entry("a", "k")));
    EXPECT_TRUE(ask(&guest, blackboard::kReqSubscribeToGroup, entry("a", "")));
    EXPECT_TRUE(set("a", "k", {1}));
    EXPECT_THAT(updates(), ElementsAre("a/k=1> 9"));
    EXPECT_EQ(guest.task_count(), 1u);
  }
  EXPECT_TRUE(set("a", "k", {2}));
  EXPECT_THAT(updates(), IsEmpty());
}

TEST_F(Blackboard, carries_out_the_requests_of_drivers_on_the_io_thread_as_of_one_client) {
  EXPECT_TRUE(ask(nullptr, blackboard::kReqSubscribeToKey, entry("a", "k")));
  EXPECT_TRUE(ask(nullptr, blackboard::kReqSetEntry, entry("a", "k", {1})));
  EXPECT_THAT(updates(), ElementsAre("a/k=1> 0"));
}

TEST_F(Blackboard, refuses_what_is_over_its_limits_and_what_is_no_entry) {
  const std::size_t room = limits::kBlackboardEntryBytes - 2;
  EXPECT_TRUE(set("a", "k", std::vector<std::uint8_t>(room)));
  EXPECT_FALSE(set("a", "k", std::vector<std::uint8_t>(room + 1)));
  const std::string longest(limits::kBlackboardNameBytes - 1, 'x');
  EXPECT_TRUE(ask(&one, blackboard::kReqGetEntry, entry("a", longest)));
  EXPECT_FALSE(ask(&one, blackboard::kReqGetEntry, entry("aa", longest)));
  EXPECT_FALSE(ask(&one, blackboard::kReqSubscribeToGroup, entry("aa" + longest, "")));
  for (std::size_t i = 1; i < limits::kBlackboardEntries; ++i)
    ASSERT_TRUE(set("a", std::to_string(i), {1})) << i;
  EXPECT_FALSE(set("a", "one more", {1}));
  EXPECT_TRUE(set("a", "1", {2})) << "an entry that is there has room";
  for (std::size_t i = 0; i < limits::kBlackboardSubscriptions; ++i)
    ASSERT_TRUE(ask(&one, blackboard::kReqSubscribeToKey, entry("a", std::to_string(i)))) << i;
  EXPECT_FALSE(ask(&one, blackboard::kReqSubscribeToGroup, entry("a", "")));
  EXPECT_FALSE(ask(&one, blackboard::kReqSubscribeToKey, entry("a", "one more")));
  EXPECT_TRUE(ask(&one, blackboard::kReqSubscribeToKey, entry("a", "1")));
  EXPECT_TRUE(ask(&two, blackboard::kReqSubscribeToKey, entry("a", "one more"))) << "each client has its own";
  EXPECT_TRUE(ask(&one, blackboard::kReqUnsubscribeFromKey, entry("a", "1")));
  EXPECT_TRUE(ask(&one, blackboard::kReqSubscribeToKey, entry("a", "one more")));

  ++ticket;
  site.driver(board).request({site.id(board), kRequest, blackboard::kReqGetEntry, {}, &one},
                             device::Replier(site.recorder, ticket));
  EXPECT_FALSE(site.recorder.answers.at(ticket).ack);
}

TEST_F(Blackboard, knows_its_requests) {
  const device::Driver& driver = site.driver(board);
  for (const std::uint8_t subtype : {blackboard::kReqSubscribeToKey, blackboard::kReqGetEntry})
    EXPECT_TRUE(driver.capable(site.id(board), kRequest, subtype));
  EXPECT_FALSE(driver.capable(site.id(board), kRequest, 0));
  EXPECT_FALSE(driver.capable(site.id(board), kRequest, 7));
  EXPECT_FALSE(driver.capable(site.id(board), 2, blackboard::kReqGetEntry));
}

}  // namespace
}  // namespace playhouse::drivers
