#include "playhouse/server/out_queue.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "playhouse/base/limits.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"

namespace playhouse::server {
namespace {

Frame frame(wire::MessageType type, std::uint16_t interf, std::uint32_t tag, std::size_t body_bytes = 0) {
  wire::Header header;
  header.interf = interf;
  header.type = type;
  header.subtype = 1;
  header.seq = tag;
  return make_frame(header, std::vector<std::byte>(body_bytes));
}
Frame data(std::uint16_t interf, std::uint32_t tag) {
  return frame(wire::MessageType::kData, interf, tag);
}
Frame ack(std::uint32_t tag) {
  return frame(wire::MessageType::kAck, 1, tag);
}

/// What goes out, as "D4.1" for data of interface 4 with tag 1, "A2" for an ACK, "S1" for a SYNCH by its
/// subtype.
std::string taken(OutQueue& queue, std::size_t max_bytes = 1 << 30) {
  std::vector<net::SharedBytes> out;
  queue.take(out, max_bytes, 5.0);
  std::string text;
  for (const net::SharedBytes& bytes : out) {
    const wire::Header header = wire::decode_header(std::span(*bytes).first<limits::kHeaderBytes>());
    if (!text.empty()) text += " ";
    switch (header.type) {
      case wire::MessageType::kData:
        text += "D" + std::to_string(header.interf) + "." + std::to_string(header.seq);
        break;
      case wire::MessageType::kSynch:
        text += "S" + std::to_string(header.subtype);
        break;
      default:
        text += "A" + std::to_string(header.seq);
    }
  }
  return text;
}

std::uint32_t overflow_count(OutQueue& queue) {
  std::vector<net::SharedBytes> out;
  queue.take(out, std::size_t{1} << 40, 5.0);
  const auto body = std::span(*out.back()).subspan(limits::kHeaderBytes);
  return wire::decode<wire::Uint32>(body)->value;
}

TEST(OutQueue, sends_everything_in_order_when_pushing) {
  OutQueue queue;
  queue.add(data(4, 1));
  queue.add(ack(2));
  queue.add(data(6, 3));
  EXPECT_EQ(taken(queue), "D4.1 A2 D6.3");
  EXPECT_EQ(queue.waiting(), 0u);
}

TEST(OutQueue, stops_at_the_size_it_was_given) {
  OutQueue queue;
  for (std::uint32_t i = 0; i < 5; ++i) queue.add(data(4, i));
  EXPECT_EQ(taken(queue, 80), "D4.0 D4.1");
  EXPECT_EQ(queue.waiting(), 3u);
}

TEST(OutQueue, holds_data_until_it_is_asked_for_and_ends_the_round_with_a_synch) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.add(data(4, 1));
  queue.add(data(6, 2));
  EXPECT_EQ(taken(queue), "");
  queue.request_data(ack(9));
  EXPECT_EQ(taken(queue), "A9 D4.1 D6.2 S1");
  queue.add(data(4, 3));
  EXPECT_EQ(taken(queue), "");
}

TEST(OutQueue, never_sends_a_synch_without_data) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.request_data(ack(9));
  EXPECT_EQ(taken(queue), "A9");
  queue.add(data(4, 1));
  EXPECT_EQ(taken(queue), "D4.1 S1");
}

TEST(OutQueue, answers_twice_asked_with_one_synch) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.request_data(ack(8));
  queue.request_data(ack(9));
  EXPECT_EQ(taken(queue), "A9 A8");
  queue.add(data(4, 1));
  EXPECT_EQ(taken(queue), "D4.1 S1");
}

TEST(OutQueue, lets_data_wait_for_their_round_when_an_answer_goes_out) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.add(data(4, 1));
  queue.add(ack(2));
  queue.add(data(4, 3));
  EXPECT_EQ(taken(queue), "A2");
  EXPECT_FALSE(queue.has_output());
  queue.request_data(ack(4));
  EXPECT_EQ(taken(queue), "A4 D4.1 D4.3 S1");
}

TEST(OutQueue, sends_what_waited_for_a_round_when_the_client_turns_to_push) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.add(data(4, 1));
  queue.set_mode(DeliveryMode::kPush);
  EXPECT_EQ(taken(queue), "D4.1");
}

TEST(OutQueue, keeps_answers_in_their_place_among_the_data_of_an_open_round) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.request_data(ack(9));
  EXPECT_EQ(taken(queue), "A9");
  queue.add(data(4, 1));
  queue.add(ack(2));
  queue.add(data(4, 3));
  EXPECT_EQ(taken(queue), "D4.1 A2 D4.3 S1");
}

TEST(OutQueue, ends_a_round_even_when_data_comes_faster_than_it_goes) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.add(data(4, 1));
  queue.add(data(4, 2));
  queue.request_data(ack(9));
  EXPECT_EQ(taken(queue, 80), "A9 D4.1");
  queue.add(data(4, 3));
  EXPECT_EQ(taken(queue, 80), "D4.2 S1");
  EXPECT_EQ(taken(queue), "");
}

TEST(OutQueue, replaces_by_rule_at_the_end_and_leaves_out_by_rule) {
  OutQueue queue;
  ASSERT_TRUE(queue.add_rule({4, -1, 1, -1, QueueAction::kReplace}));
  ASSERT_TRUE(queue.add_rule({6, -1, 1, -1, QueueAction::kIgnore}));
  queue.add(data(4, 1));
  queue.add(data(5, 2));
  queue.add(data(4, 3));
  queue.add(data(6, 4));
  EXPECT_EQ(taken(queue), "D5.2 D4.3");
}

TEST(OutQueue, goes_by_the_first_rule_that_matches) {
  OutQueue queue;
  ASSERT_TRUE(queue.add_rule({-1, -1, 1, -1, QueueAction::kReplace}));
  ASSERT_TRUE(queue.add_rule({6, -1, 1, -1, QueueAction::kIgnore}));
  queue.add(data(6, 1));
  queue.add(data(6, 2));
  EXPECT_EQ(taken(queue), "D6.2");
  ASSERT_TRUE(
      queue.add_rule({-5, -1, 1, -7, QueueAction::kIgnore}));  // the first rule again: negative is negative
  queue.add(data(6, 3));
  EXPECT_EQ(taken(queue), "");
}

TEST(OutQueue, can_be_told_to_leave_out_answers_but_not_the_answer_to_a_request_for_data) {
  OutQueue queue;
  ASSERT_TRUE(queue.add_rule({-1, -1, -1, -1, QueueAction::kIgnore}));
  queue.add(ack(1));
  queue.add(data(4, 2));
  queue.request_data(ack(3));
  EXPECT_EQ(taken(queue), "A3");
}

TEST(OutQueue, has_a_limit_of_rules) {
  OutQueue queue;
  for (std::size_t i = 0; i < limits::kSessionRules; ++i) {
    ASSERT_TRUE(queue.add_rule({static_cast<std::int32_t>(i), -1, -1, -1, QueueAction::kAccept}));
  }
  EXPECT_FALSE(queue.add_rule({9999, -1, -1, -1, QueueAction::kAccept}));
  EXPECT_TRUE(queue.add_rule({0, -1, -1, -1, QueueAction::kIgnore}));
}

TEST(OutQueue, drops_the_oldest_data_over_the_limit_and_tells_the_true_count) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  for (std::uint32_t i = 0; i < limits::kSessionQueueMessages + 3; ++i) queue.add(data(4, i));
  EXPECT_EQ(queue.waiting(), limits::kSessionQueueMessages);
  EXPECT_EQ(queue.dropped(), 3u);
  queue.request_data(ack(0));
  EXPECT_EQ(taken(queue, 80), "A0 D4.3");
  EXPECT_EQ(overflow_count(queue), 3u);
  queue.add(data(4, 1));
  queue.request_data(ack(0));
  EXPECT_EQ(taken(queue), "A0 D4.1 S1");
}

Frame data_of(std::uint16_t index, std::uint32_t tag, std::size_t body_bytes = 0) {
  wire::Header header;
  header.interf = 62;
  header.index = index;
  header.type = wire::MessageType::kData;
  header.subtype = 1;
  header.seq = tag;
  return make_frame(header, std::vector<std::byte>(body_bytes));
}

/// Takes a whole round and counts what it has of each device.
std::uint32_t take_round(OutQueue& queue, std::vector<std::size_t>& got) {
  queue.request_data(ack(0));
  std::vector<net::SharedBytes> out;
  queue.take(out, std::size_t{1} << 40, 5.0);
  std::uint32_t lost = 0;
  for (const net::SharedBytes& bytes : out) {
    const wire::Header header = wire::decode_header(std::span(*bytes).first<limits::kHeaderBytes>());
    if (header.type == wire::MessageType::kData) ++got.at(header.index);
    if (header.type == wire::MessageType::kSynch && header.size > 0)
      lost = wire::decode<wire::Uint32>(std::span(*bytes).subspan(limits::kHeaderBytes))->value;
  }
  return lost;
}

TEST(OutQueue, a_full_queue_is_shared_evenly_by_a_thousand_devices_and_every_loss_is_told) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  constexpr std::uint16_t kDevices = 1000;
  constexpr std::size_t kRounds = 50, kTicks = 3;
  std::vector<std::size_t> got(kDevices);
  std::size_t lost = 0;
  for (std::size_t round = 0; round < kRounds; ++round) {
    for (std::uint32_t tick = 0; tick < kTicks; ++tick)
      for (std::uint16_t device = 0; device < kDevices; ++device) queue.add(data_of(device, tick));
    EXPECT_EQ(queue.waiting(), limits::kSessionQueueMessages);
    lost += take_round(queue, got);
  }
  const auto [least, most] = std::ranges::minmax(got);
  EXPECT_GE(least, kRounds) << "the newest of each, always";
  EXPECT_LE(most - least, 2u);
  EXPECT_EQ(std::accumulate(got.begin(), got.end(), lost), kRounds * kTicks * kDevices);
}

TEST(OutQueue, has_room_for_the_newest_of_each_kind_however_many_there_are) {
  OutQueue queue;
  constexpr auto kDevices = static_cast<std::uint16_t>(2 * limits::kSessionQueueMessages);
  for (std::uint32_t tick = 0; tick < 3; ++tick)
    for (std::uint16_t device = 0; device < kDevices; ++device) queue.add(data_of(device, tick));
  EXPECT_EQ(queue.waiting(), kDevices);
  EXPECT_EQ(queue.dropped(), 2u * kDevices);
  EXPECT_EQ(taken(queue, 40), "D62.2");
}

TEST(OutQueue, a_device_that_sends_much_takes_nothing_from_one_that_sends_little) {
  OutQueue queue;
  queue.add(data_of(7, 1));
  for (std::uint32_t i = 0; i < 2 * limits::kSessionQueueMessages; ++i) queue.add(data_of(8, i));
  queue.add(data_of(7, 2));
  EXPECT_EQ(taken(queue, 40), "D62.1");
}

TEST(OutQueue, the_limit_in_bytes_is_shared_evenly_too) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  constexpr std::uint16_t kDevices = 10;
  constexpr std::size_t kRounds = 20;
  std::vector<std::size_t> got(kDevices);
  std::vector<Frame> frames;
  for (std::uint16_t device = 0; device < kDevices; ++device)
    frames.push_back(data_of(device, 0, limits::kSessionQueueBytes / 5));
  for (std::size_t round = 0; round < kRounds; ++round) {
    for (const Frame& frame : frames) queue.add(frame);
    take_round(queue, got);
  }
  const auto [least, most] = std::ranges::minmax(got);
  EXPECT_EQ(std::accumulate(got.begin(), got.end(), std::size_t{0}), 4 * kRounds);
  EXPECT_LE(most - least, 1u);
}

TEST(OutQueue, sends_everything_unasked_at_the_end_round_by_round) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  for (std::uint32_t i = 0; i < limits::kSessionQueueMessages + 2; ++i) queue.add(data(4, i));
  queue.request_data(ack(0));
  EXPECT_EQ(taken(queue, 80), "A0 D4.2");
  queue.add(data(4, 9999));
  queue.send_unasked();
  const std::string rest = taken(queue);
  EXPECT_TRUE(rest.starts_with("D4.3 D4.4 ")) << rest.substr(0, 40);
  EXPECT_TRUE(rest.ends_with(" D4.1025 S2 D4.9999 S1")) << rest.substr(rest.size() - 40);
  EXPECT_EQ(taken(queue), "");
}

TEST(OutQueue, is_bounded_in_bytes_too) {
  OutQueue queue;
  const Frame big = frame(wire::MessageType::kData, 40, 0, limits::kSessionQueueBytes / 4);
  for (int i = 0; i < 10; ++i) queue.add(big);
  EXPECT_EQ(queue.waiting(), 3u);
  EXPECT_EQ(queue.dropped(), 7u);
}

TEST(OutQueue, a_notice_goes_out_behind_the_data_of_its_device_when_pushing_unless_an_answer_is_awaited) {
  OutQueue queue;
  queue.add(data(4, 1));
  queue.set_awaited(true);
  queue.add_notice(4, 0, ack(99));
  EXPECT_EQ(taken(queue), "D4.1");
  EXPECT_FALSE(queue.has_output());
  queue.add(ack(2));
  queue.set_awaited(false);
  EXPECT_EQ(taken(queue), "A99 A2");
}

TEST(OutQueue, a_notice_waits_for_a_round_in_pull_mode_as_data_do) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.add(data(4, 1));
  queue.add_notice(4, 0, ack(99));
  queue.add(data(6, 2));
  queue.add(ack(3));
  EXPECT_EQ(taken(queue), "A3");
  EXPECT_FALSE(queue.has_output());
  queue.add(data(6, 4));
  queue.request_data(ack(5));
  EXPECT_EQ(taken(queue), "A5 D4.1 A99 D6.2 D6.4 S1");
}

TEST(OutQueue, a_notice_goes_out_in_its_place_in_the_round_and_does_not_end_it) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.add(data(4, 1));
  queue.add_notice(4, 0, ack(99));
  queue.request_data(ack(2));
  EXPECT_EQ(taken(queue), "A2 D4.1 A99 S1");
  queue.request_data(ack(3));
  queue.add_notice(6, 0, ack(98));
  EXPECT_EQ(taken(queue), "A3 A98") << "a SYNCH needs data";
  queue.add(data(7, 4));
  EXPECT_EQ(taken(queue), "D7.4 S1");
}

TEST(OutQueue, a_notice_goes_out_whatever_the_rules_are_and_unasked_at_the_end) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.add_rule({-1, -1, -1, -1, QueueAction::kIgnore});
  queue.add_notice(4, 0, ack(99));
  EXPECT_EQ(queue.waiting(), 0u) << "it holds up no end";
  queue.send_unasked();
  EXPECT_EQ(taken(queue), "A99");
}

TEST(OutQueue, knows_nothing_of_a_device_once_its_notice_is_out) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  for (std::uint16_t device = 0; device < 100; ++device) {
    queue.add(data(device, 1));
    queue.add_notice(device, 0, ack(99));
  }
  EXPECT_EQ(queue.kinds(), 100u);
  queue.request_data(ack(2));
  taken(queue);
  EXPECT_EQ(queue.kinds(), 0u);
  EXPECT_EQ(queue.notices_waiting(), 0u);
  EXPECT_EQ(queue.bytes_waiting(), 0u);
}

TEST(OutQueue, a_device_in_the_place_of_another_gets_none_of_its_data_and_the_notice_before_the_next_answer) {
  OutQueue queue;
  queue.set_mode(DeliveryMode::kPull);
  queue.add(data(4, 1));
  queue.add(data(6, 1));
  queue.add_notice(4, 0, ack(99));
  queue.add_notice(6, 0, ack(98));
  queue.replace_device(4, 0);
  queue.add(ack(2));
  queue.add(data(4, 3));
  EXPECT_EQ(taken(queue), "A99 A2");
  queue.request_data(ack(5));
  EXPECT_EQ(taken(queue), "A5 D6.1 A98 D4.3 S1");
  EXPECT_EQ(queue.bytes_waiting(), 0u);
}

TEST(OutQueue, never_drops_an_answer) {
  OutQueue queue;
  queue.add(ack(1));
  for (std::uint32_t i = 0; i < 2 * limits::kSessionQueueMessages; ++i) queue.add(data(4, i));
  EXPECT_EQ(queue.answers_waiting(), 1u);
  EXPECT_EQ(taken(queue, 40), "A1");
}

TEST(OutQueue, forgets_the_data_of_a_device_and_nothing_else) {
  OutQueue queue;
  queue.add(data(4, 1));
  queue.add(data(6, 2));
  queue.add(ack(3));
  queue.add(data(4, 4));
  queue.forget(4, 0);
  EXPECT_EQ(taken(queue), "D6.2 A3");
}

/// The same rules, written the long way round: one list, searched each time.
class SlowQueue {
 public:
  bool pull = false;
  ReplaceRules rules;
  void add(const Frame& frame) {
    const QueueAction action = rules.action_for(frame);
    if (action == QueueAction::kIgnore) return;
    if (action == QueueAction::kReplace) {
      for (std::size_t i = list_.size(); i-- > 0;) {
        if (list_[i].kind() != frame.kind()) continue;
        list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(i));
        break;
      }
    }
    list_.push_back(frame);
  }
  void request(const Frame& answer) {
    list_.insert(list_.begin(), answer);
    requested_ = true;
    delivered_ = false;
  }
  /// Everything that may go, the SYNCH as null.
  std::vector<net::SharedBytes> take_all() {
    std::vector<net::SharedBytes> out;
    for (;;) {
      if (list_.empty()) {
        if (!pull || !requested_ || !delivered_) return out;
        requested_ = delivered_ = false;
        out.push_back(nullptr);
        continue;
      }
      const auto next = std::find_if(list_.begin(), list_.end(),
                                     [&](const Frame& f) { return f.is_answer() || !pull || requested_; });
      if (next == list_.end()) return out;
      if (requested_ && !next->is_answer()) delivered_ = true;
      out.push_back(next->bytes);
      list_.erase(next);
    }
  }

 private:
  std::vector<Frame> list_;
  bool requested_ = false, delivered_ = false;
};

RC_GTEST_PROP(OutQueue, sends_what_the_slow_queue_sends_when_nothing_overflows, ()) {
  OutQueue queue;
  SlowQueue oracle;
  for (const int step : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 100))) {
    const auto interf = static_cast<std::uint16_t>(4 + step % 3);
    if (step < 45) {
      const Frame f = data(interf, static_cast<std::uint32_t>(step));
      queue.add(f);
      oracle.add(f);
    } else if (step < 60) {
      const Frame f = ack(static_cast<std::uint32_t>(step));
      queue.add(f);
      oracle.add(f);
    } else if (step < 75) {
      const Frame f = ack(static_cast<std::uint32_t>(step));
      queue.request_data(f);
      oracle.request(f);
    } else if (step < 85) {
      const bool pull = step % 2 == 0;
      queue.set_mode(pull ? DeliveryMode::kPull : DeliveryMode::kPush);
      oracle.pull = pull;
    } else if (step < 90) {
      const ReplaceRule rule{interf, -1, 1, -1, static_cast<QueueAction>(step % 3)};
      RC_ASSERT(queue.add_rule(rule) == oracle.rules.add(rule));
    }
    std::vector<net::SharedBytes> out;
    queue.take(out, std::size_t{1} << 40, 0);
    const auto expected = oracle.take_all();
    RC_ASSERT(out.size() == expected.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      const bool synch = wire::decode_header(std::span(*out[i]).first<limits::kHeaderBytes>()).type ==
                         wire::MessageType::kSynch;
      RC_ASSERT((expected[i] ? out[i] == expected[i] : synch));
    }
  }
}

}  // namespace
}  // namespace playhouse::server
