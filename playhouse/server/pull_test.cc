// What clients see that read slowly, rarely or by rules of their own, over the simulated network: nobody else
// notices, and they are told what they missed. Out of scope here: the order within one queue
// (out_queue_test.cc).

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <sstream>

#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::server {
namespace {

constexpr std::uint16_t kWheels = wire::position2d::kCode, kLaser = wire::laser::kCode, kPort = 6665;
constexpr std::uint8_t kPull = 2, kGetGeom = wire::position2d::kReqGetGeom;
constexpr std::int32_t kAny = -1, kData = 1, kAnAck = 4;
constexpr std::int32_t kAccept = 0, kReplace = 1, kIgnore = 2;

/// The log lines since it was made.
class LogLines {
 public:
  LogLines() {
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_)));
  }
  ~LogLines() { spdlog::set_default_logger(before_); }
  std::ptrdiff_t count(const std::string& words) const {
    std::istringstream lines(text_.str());
    std::ptrdiff_t found = 0;
    for (std::string line; std::getline(lines, line);) found += line.find(words) != std::string::npos;
    return found;
  }

 private:
  std::ostringstream text_;
  std::shared_ptr<spdlog::logger> before_ = spdlog::default_logger();
};

struct Rule {
  std::int32_t interf, index, type, subtype, action;
};

class Pull : public ::testing::Test {
 protected:
  Pull() {
    EXPECT_EQ(*server.listen(kPort), kPort);
    wheels_id = *server.add_device({kPort, kWheels, 0}, driver);
    laser_id = *server.add_device({kPort, kLaser, 0}, driver);
    driver.answers[kGetGeom] = {};
  }
  TestClient client_of_both(std::uint8_t mode) {
    TestClient client(network, kPort);
    client.send(mode_request(mode));
    client.send(open_request(kWheels, 0));
    client.send(open_request(kLaser, 0));
    EXPECT_EQ(client.read().size(), 3u);
    return client;
  }
  void publish(device::DeviceId id, std::size_t bytes = 52) {
    std::vector<device::Publication> batch;
    batch.push_back({id, 1, ++time, Bytes(bytes)});
    server.publish(std::move(batch));
  }
  void finish() {
    server.finish([this] { finished = true; });
    network.run();
  }
  static Bytes round() { return player_request(wire::player::kReqData); }
  static std::string add(TestClient& client, const Rule& rule) {
    const wire::player::AddReplaceRuleReq body{rule.interf, rule.index, rule.type, rule.subtype, rule.action};
    return outline(client.ask(player_request(wire::player::kReqAddReplaceRule, wire::encode(body))));
  }
  static std::ptrdiff_t count(const std::vector<Received>& messages, wire::MessageType type,
                              std::uint16_t interf) {
    return std::ranges::count_if(messages, [=](const Received& received) {
      return received.header.type == type && received.header.interf == interf;
    });
  }
  /// Of three messages of each device, what a round holds: "2 1" for two of the wheels and one of the laser.
  std::string kept_of_three(TestClient& client) {
    for (int i = 0; i < 3; ++i) {
      publish(wheels_id);
      publish(laser_id);
    }
    const auto got = client.ask(round());
    return std::to_string(count(got, wire::MessageType::kData, kWheels)) + " " +
           std::to_string(count(got, wire::MessageType::kData, kLaser));
  }
  static std::uint32_t overflow_of(const Received& synch) {
    EXPECT_EQ(synch.header.type, wire::MessageType::kSynch);
    if (synch.header.subtype == wire::player::kSynchOk) return 0;
    return wire::decode<wire::Uint32>(synch.body)->value;
  }

  net::SimulatedNetwork network{5};
  FakeDriver driver;
  Server server{network};
  device::DeviceId wheels_id, laser_id;
  double time = 0;
  bool finished = false;
};

TEST_F(Pull, a_refused_open_names_the_device_that_was_wanted_and_the_nearest) {
  const LogLines log;
  TestClient client(network, kPort);
  EXPECT_EQ(outline(client.ask(open_request(kLaser, 7))), "NACK 3");
  EXPECT_EQ(log.count("open of 6665:laser:7: no such device, the nearest is 6665:laser:0; answered NACK"), 1);
  driver.fails_to_start = true;
  client.ask(open_request(kWheels, 0));
  EXPECT_EQ(log.count("open of 6665:position2d:0: the device cannot start: /dev/none: no such device"), 1);
}

TEST_F(Pull, a_client_that_asks_rarely_gets_the_newest_and_hears_once_how_much_it_missed) {
  constexpr std::size_t kMissed = 7;
  const LogLines log;
  TestClient rare = client_of_both(kPull), other = client_of_both(1);
  std::size_t heard_by_other = 0;
  for (std::size_t i = 0; i < limits::kSessionQueueMessages + kMissed; ++i) {
    publish(wheels_id);
    heard_by_other += other.read().size();
  }
  EXPECT_EQ(heard_by_other, limits::kSessionQueueMessages + kMissed);
  EXPECT_EQ(server.status().data_dropped, kMissed);
  EXPECT_EQ(log.count("reads too slowly"), 1);

  auto got = rare.ask(round());
  ASSERT_EQ(got.size(), limits::kSessionQueueMessages + 2) << "the answer, the data, the SYNCH";
  EXPECT_EQ(got[1].header.timestamp, kMissed + 1) << "the oldest is what is missing";
  EXPECT_EQ(overflow_of(got.back()), kMissed);
  publish(wheels_id);
  got = rare.ask(round());
  EXPECT_EQ(outline(got), "ACK 4, DATA 1 of 4, SYNCH 1") << "it was told before";
}

TEST_F(Pull, a_client_that_stops_reading_amid_a_round_gets_its_end_and_the_true_count) {
  network.window_bytes = 4096;
  constexpr std::size_t kBefore = 600, kDuring = 3000, kLong = 1000;
  TestClient slow = client_of_both(kPull), other = client_of_both(1);
  std::size_t heard_by_other = 0;
  for (std::size_t i = 0; i < kBefore; ++i) publish(wheels_id, kLong);
  slow.peer.stall();
  slow.send(round());
  for (std::size_t i = 0; i < kDuring; ++i) {
    heard_by_other += other.read().size();
    publish(wheels_id, kLong);
  }
  heard_by_other += other.read().size();
  EXPECT_EQ(heard_by_other, kBefore + kDuring);
  EXPECT_EQ(server.status().stalled_sessions, 1u);

  slow.peer.read_on();
  const auto first = slow.read();
  EXPECT_EQ(count(first, wire::MessageType::kSynch, wire::player::kCode), 1);
  const auto second = slow.ask(round());
  const auto data = static_cast<std::size_t>(count(first, wire::MessageType::kData, kWheels) +
                                             count(second, wire::MessageType::kData, kWheels));
  EXPECT_GT(server.status().data_dropped, kDuring - limits::kSessionQueueMessages - 300)
      << "300: on their way";
  EXPECT_EQ(data + server.status().data_dropped, kBefore + kDuring);
  EXPECT_EQ(overflow_of(first.back()) + overflow_of(second.back()), server.status().data_dropped);
  EXPECT_EQ(second[second.size() - 2].header.timestamp, kBefore + kDuring) << "the newest is kept";
}

TEST_F(Pull, a_client_that_asks_for_rounds_without_reading_is_not_read_any_more) {
  network.window_bytes = 4096;
  TestClient greedy = client_of_both(kPull), other = client_of_both(kPull);
  greedy.peer.stall();
  constexpr std::size_t kRounds = 20000;
  for (std::size_t i = 0; i < kRounds; ++i) greedy.send(round());
  network.run();
  EXPECT_LT(server.status().messages_received, kRounds / 2);
  publish(wheels_id);
  EXPECT_EQ(outline(other.ask(round())), "ACK 4, DATA 1 of 4, SYNCH 1");
  greedy.peer.read_on();
  EXPECT_EQ(count(greedy.read(), wire::MessageType::kAck, wire::player::kCode),
            static_cast<std::ptrdiff_t>(kRounds));
}

TEST_F(Pull, an_answer_waits_for_no_round_and_leaves_the_data_to_the_next) {
  TestClient client = client_of_both(kPull);
  publish(wheels_id);
  EXPECT_EQ(outline(client.ask(message(wire::MessageType::kReq, kWheels, 0, kGetGeom))), "ACK 1");
  EXPECT_EQ(outline(client.ask(round())), "ACK 4, DATA 1 of 4, SYNCH 1");
}

TEST_F(Pull, rules_go_by_every_field_and_negative_ones_match_all) {
  const struct {
    Rule rule;
    const char* kept;
  } cases[] = {
      {{kAny, kAny, kAny, kAny, kReplace}, "1 1"},
      {{kAny, kAny, kData, kAny, kReplace}, "1 1"},
      {{kWheels, kAny, kData, kAny, kReplace}, "1 3"},
      {{kWheels, 0, kData, 1, kReplace}, "1 3"},
      {{kAny, 0, kData, 1, kReplace}, "1 1"},
      {{kWheels, 1, kData, 1, kReplace}, "3 3"},  // another index
      {{kWheels, 0, 2, 1, kReplace}, "3 3"},      // commands
      {{kWheels, 0, kData, 2, kReplace}, "3 3"},  // another subtype
      {{kLaser, kAny, kAny, kAny, kIgnore}, "3 0"},
      {{-7, 0, kData, -9, kIgnore}, "0 0"},
      {{kAny, kAny, kData, kAny, kAccept}, "3 3"},
      {{kAny, kAny, kData, kAny, 9}, "3 3"},  // no such action
  };
  for (const auto& one : cases) {
    TestClient client = client_of_both(kPull);
    ASSERT_EQ(add(client, one.rule), "ACK 10");
    EXPECT_EQ(kept_of_three(client), one.kept)
        << one.rule.interf << " " << one.rule.index << " " << one.rule.type << " " << one.rule.subtype;
  }
}

TEST_F(Pull, the_first_rule_that_matches_decides_and_the_same_rule_again_takes_its_place) {
  TestClient client = client_of_both(kPull);
  add(client, {kWheels, kAny, kData, kAny, kAccept});
  add(client, {kAny, kAny, kData, kAny, kIgnore});
  EXPECT_EQ(kept_of_three(client), "3 0");
  add(client, {kWheels, kAny, kData, kAny, kReplace});
  publish(wheels_id);
  client.read();
  EXPECT_EQ(kept_of_three(client), "1 0");
}

TEST_F(Pull, rules_are_a_clients_own) {
  TestClient deaf = client_of_both(kPull), other = client_of_both(kPull);
  add(deaf, {kAny, kAny, kData, kAny, kIgnore});
  EXPECT_EQ(kept_of_three(other), "3 3");
  EXPECT_EQ(outline(deaf.ask(round())), "ACK 4") << "a round without data does not end";
}

TEST_F(Pull, a_rule_may_leave_out_answers_but_not_the_one_that_begins_a_round) {
  TestClient client = client_of_both(kPull);
  EXPECT_EQ(add(client, {kAny, kAny, kAnAck, kAny, kIgnore}), "") << "not even that of the rule itself";
  EXPECT_EQ(outline(client.ask(message(wire::MessageType::kReq, kWheels, 0, kGetGeom))), "");
  EXPECT_EQ(outline(client.ask(message(wire::MessageType::kReq, kWheels, 0, 200))), "NACK 200");
  publish(wheels_id);
  EXPECT_EQ(outline(client.ask(round())), "ACK 4, DATA 1 of 4, SYNCH 1");
}

TEST_F(Pull, a_rule_too_many_gets_nack_and_the_others_stay) {
  TestClient client = client_of_both(kPull);
  for (std::size_t i = 0; i < limits::kSessionRules; ++i) {
    ASSERT_EQ(add(client, {kLaser, static_cast<std::int32_t>(i), kData, kAny, kIgnore}), "ACK 10");
  }
  EXPECT_EQ(add(client, {kWheels, kAny, kData, kAny, kIgnore}), "NACK 10");
  EXPECT_EQ(kept_of_three(client), "3 0");
}

TEST_F(Pull, after_the_run_a_client_gets_what_waits_when_it_asks_and_then_the_end) {
  TestClient client = client_of_both(kPull), push = client_of_both(1), idle(network, kPort);
  constexpr std::ptrdiff_t kScans = 600;
  for (std::ptrdiff_t i = 0; i < kScans; ++i) publish(wheels_id);
  finish();
  EXPECT_EQ(count(push.read(), wire::MessageType::kData, kWheels), kScans);
  EXPECT_TRUE(push.peer.closed());
  EXPECT_TRUE(idle.peer.closed());
  EXPECT_FALSE(client.peer.closed());
  EXPECT_FALSE(finished);
  const auto got = client.ask(round());
  EXPECT_EQ(count(got, wire::MessageType::kData, kWheels), kScans);
  EXPECT_EQ(overflow_of(got.back()), 0u);
  EXPECT_TRUE(client.peer.closed());
  EXPECT_TRUE(finished);
}

TEST_F(Pull, after_the_run_who_does_not_ask_gets_what_waits_unasked_with_the_count_of_what_is_missing) {
  const LogLines log;
  TestClient client = client_of_both(kPull);
  constexpr std::size_t kMissed = 7;
  for (std::size_t i = 0; i < limits::kSessionQueueMessages + kMissed; ++i) publish(wheels_id);
  finish();
  EXPECT_TRUE(client.read().empty());
  network.run_for(1);
  const auto got = client.read();
  EXPECT_EQ(got.size(), limits::kSessionQueueMessages + 1);
  EXPECT_EQ(overflow_of(got.back()), kMissed);
  EXPECT_TRUE(client.peer.closed());
  EXPECT_TRUE(finished);
  EXPECT_EQ(log.count("not read before the end"), 0);
}

TEST_F(Pull, who_does_not_read_holds_up_the_end_for_two_seconds_and_its_loss_is_logged) {
  network.window_bytes = 4096;
  const LogLines log;
  TestClient client = client_of_both(1);
  client.peer.stall();
  for (int i = 0; i < 1000; ++i) publish(wheels_id, 1000);
  finish();
  network.run_for(1.9);
  EXPECT_FALSE(finished);
  network.run_for(0.2);
  EXPECT_TRUE(finished);
  EXPECT_EQ(log.count("data messages were not read before the end"), 1);
}

TEST_F(Pull, after_the_run_a_server_without_clients_ends_at_once) {
  finish();
  EXPECT_TRUE(finished);
}

TEST_F(Pull, data_that_the_server_had_no_time_for_is_counted_and_told_once) {
  network.piece_bytes = network.window_bytes = 1u << 20;
  constexpr std::size_t kThird = limits::kOutboxBytes / 3;
  const LogLines log;
  TestClient client = client_of_both(1);
  for (int times = 0; times < 2; ++times) {
    for (int i = 0; i < 3; ++i) publish(wheels_id, kThird);
    EXPECT_EQ(client.read().size(), 1u);
  }
  EXPECT_EQ(server.status().data_dropped, 4u);
  EXPECT_EQ(log.count("the server is too busy"), 1);
}

TEST_F(Pull, gets_nothing_of_a_run_that_was_restarted) {
  TestClient client = client_of_both(kPull);
  const auto state = [&](double x) {
    return device::Publication{wheels_id, wire::position2d::kDataState, x,
                               wire::encode(wire::position2d::Data{{x, 0, 0}, {}, 0})};
  };
  server.publish({state(1), state(2)});
  network.run();
  server.publish({state(3)});
  server.forget();
  server.publish({state(0.5)});
  network.run();
  const std::vector<Received> got = client.ask(round());
  ASSERT_EQ(outline(got), "ACK 4, DATA 1 of 4, SYNCH 1");
  EXPECT_EQ(got[1].header.timestamp, 0.5);
  EXPECT_EQ(server.status().data_dropped, 0u) << "nothing was lost";
}

}  // namespace
}  // namespace playhouse::server
