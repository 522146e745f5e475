// Replays what clients sent in the recorded sessions against devices that answer as the recorded ones did,
// and compares every byte of the answers but the times. Where we differ on purpose the difference is written
// down here and in docs/server.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <stdexcept>

#include "playhouse/base/testing/reference.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/frame.h"
#include "playhouse/server/replace_rules.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"

namespace playhouse::server {
namespace {

constexpr std::uint16_t kPort = 16665;

Bytes read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("no " + path.string());  // fails the test that asked for it
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

struct Device {
  std::uint16_t interf, index;
  const char* driver;
};
// The recorded server's devices, in its order; other configurations had more.
constexpr Device kDevices[] = {{31, 0, "stage"}, {4, 0, "stage"},         {62, 0, "stage"},
                               {62, 1, "stage"}, {6, 0, "rangertolaser"}, {42, 0, "mapfile"},
                               {4, 9, "dummy"},  {51, 0, "dummy"}};

/// A request that the original answered late or not at all.
struct Difference {
  std::size_t request;                     // index in the client's stream
  std::optional<std::size_t> answer = {};  // index in the server's stream; none: silence, for us a NACK
};

struct Recording {
  std::string name;
  std::vector<Difference> differences = {};
  std::vector<Device> more_devices = {};
  std::size_t lost_data = 0;  // published before each round that ended with an overflow
};

class Replay {
 public:
  Replay(const Recording& recording, Bytes c2s, Bytes s2c) : recording_(recording) {
    s2c.erase(s2c.begin(), s2c.begin() + limits::kBannerBytes);
    requests_ = cut_messages(c2s);
    answers_ = cut_messages(s2c);
    EXPECT_EQ(*server_.listen(kPort), kPort);
    for (const Device& device : recording.more_devices) add(device);
    for (const Device& device : kDevices) add(device);
    for (const Difference& difference : recording.differences) {
      if (difference.answer) moved_.insert(*difference.answer);
    }
  }

  void run() {
    TestClient client(network_, kPort);
    std::vector<Received> got;
    for (std::size_t i = 0; i < requests_.size(); ++i) {
      publish_data_before_next_answer();
      prepare(i);
      const wire::Header& h = requests_[i].header;
      const auto replies =
          client.ask(message(h.type, h.interf, h.index, h.subtype, requests_[i].body, h.seq));
      got.insert(got.end(), replies.begin(), replies.end());
    }
    publish_data_before_next_answer();
    const auto rest = client.read();
    got.insert(got.end(), rest.begin(), rest.end());
    compare(got);
  }

 private:
  // The first of two devices at one address counts.
  void add(const Device& device) {
    if (ids_.contains({device.interf, device.index})) return;
    auto driver = std::make_unique<FakeDriver>(device.driver);
    ids_[{device.interf, device.index}] = *server_.add_device({kPort, device.interf, device.index}, *driver);
    drivers_[{device.interf, device.index}] = std::move(driver);
  }

  void publish(const Received& data) {
    const auto id = ids_.find({data.header.interf, data.header.index});
    ASSERT_NE(id, ids_.end());
    std::vector<device::Publication> batch;
    batch.push_back({id->second, data.header.subtype, data.header.timestamp, data.body});
    server_.publish(std::move(batch));
    network_.run();
  }

  bool next_is(wire::MessageType type) {
    while (moved_.contains(next_)) ++next_;
    return next_ < answers_.size() && answers_[next_].header.type == type;
  }

  void publish_data_before_next_answer() {
    while (next_is(wire::MessageType::kData)) {
      publish(answers_[next_]);
      expect_data(answers_[next_++]);
    }
  }

  // In PULL mode data wait for a round, where the original sends them with any answer.
  void expect_data(const Received& data) {
    if (!pull_) return expected_.push_back(data);
    const auto kind_of = [](const Received& each) { return make_frame(each.header, {}).kind(); };
    if (rules_.action_for(make_frame(data.header, {})) == QueueAction::kReplace) {
      const auto old = std::find_if(held_.rbegin(), held_.rend(),
                                    [&](const Received& each) { return kind_of(each) == kind_of(data); });
      if (old != held_.rend()) held_.erase(std::next(old).base());
    }
    held_.push_back(data);
  }

  void expect_held() {
    expected_.insert(expected_.end(), held_.begin(), held_.end());
    held_.clear();
  }

  // Finds the recorded answer and makes the device give it.
  void prepare(std::size_t index) {
    const Received& request = requests_[index];
    for (const Difference& difference : recording_.differences) {
      if (difference.request != index) continue;
      if (!difference.answer) return expect_nack(request);
      teach(request, answers_[*difference.answer]);
      return expected_.push_back(answers_[*difference.answer]);
    }
    const bool for_server = request.header.interf == wire::player::kCode;
    if (request.header.type != wire::MessageType::kReq && !for_server) return;
    if (for_server) follow(request);
    if (next_ == answers_.size()) return static_cast<void>(++unrecorded_);  // the client had gone
    const Received& answer = answers_[next_++];
    teach(request, answer);
    expected_.push_back(answer);
    if (for_server && request.header.subtype == wire::player::kReqData) expect_round();
  }

  // In PULL mode the data that waits for a device goes when the device is closed.
  void follow(const Received& request) {
    if (request.header.subtype == wire::player::kReqDatamode) {
      const auto mode = wire::decode<wire::player::DeviceDatamodeReq>(request.body)->mode;
      if (mode == 1 || mode == 2) pull_ = mode == 2;
      if (!pull_) expect_held();
    }
    if (request.header.subtype == wire::player::kReqAddReplaceRule) {
      const auto rule = *wire::decode<wire::player::AddReplaceRuleReq>(request.body);
      rules_.add({rule.interf, rule.index, rule.type, rule.subtype, static_cast<QueueAction>(rule.replace)});
    }
    if (request.header.subtype != wire::player::kReqDev || !pull_) return;
    const auto asked = *wire::decode<wire::player::DeviceReq>(request.body);
    if (asked.access != wire::player::kCloseMode) return;
    std::erase_if(held_, [&](const Received& data) {
      return data.header.interf == asked.addr.interf && data.header.index == asked.addr.index;
    });
  }

  void expect_nack(const Received& request) {
    wire::Header header = request.header;
    header.host = wire::kLocalhost;
    header.robot = kPort;
    header.type = wire::MessageType::kNack;
    header.size = 0;
    expected_.push_back({header, {}});
  }

  void teach(const Received& request, const Received& answer) {
    const auto found = drivers_.find({request.header.interf, request.header.index});
    if (found == drivers_.end()) return;
    found->second->answers.erase(request.header.subtype);
    found->second->bounces = answer.header.type == wire::MessageType::kNack && !answer.body.empty();
    if (answer.header.type == wire::MessageType::kAck)
      found->second->answers[request.header.subtype] = answer.body;
  }

  // The data of a PULL round was there before the client asked.
  void expect_round() {
    std::size_t end = next_;
    while (end < answers_.size() && answers_[end].header.type == wire::MessageType::kData) ++end;
    if (end == answers_.size() || answers_[end].header.type != wire::MessageType::kSynch) return;
    const bool overflow = answers_[end].header.subtype == wire::player::kSynchOverflow;
    for (std::size_t i = 0; overflow && i < recording_.lost_data; ++i) publish(answers_[next_]);
    publish_data_before_next_answer();
    expect_held();
    expected_.push_back(answers_[next_++]);
    if (overflow)
      expected_.back().body = wire::encode(wire::Uint32{static_cast<std::uint32_t>(recording_.lost_data)});
  }

  void compare(std::vector<Received> got) {
    ASSERT_GE(got.size(), unrecorded_);
    got.resize(got.size() - unrecorded_);
    ASSERT_EQ(outline(got), outline(expected_));
    for (std::size_t i = 0; i < got.size(); ++i) {
      wire::Header ours = got[i].header, theirs = expected_[i].header;
      const bool data = ours.type == wire::MessageType::kData && recording_.lost_data == 0;
      EXPECT_NEAR(data ? ours.timestamp : 0, data ? theirs.timestamp : 0, 1e-6);
      ours.timestamp = theirs.timestamp = 0;
      if (ours.type == wire::MessageType::kSynch) theirs.seq = 0;  // the original sends what was in memory
      EXPECT_EQ(ours, theirs) << recording_.name << " message " << i;
      EXPECT_EQ(got[i].body, expected_[i].body) << recording_.name << " message " << i;
    }
  }

  const Recording& recording_;
  std::vector<Received> requests_, answers_, expected_;
  std::vector<Received> held_;  // data that wait for a round
  ReplaceRules rules_;
  std::set<std::size_t> moved_;
  std::size_t next_ = 0, unrecorded_ = 0;
  bool pull_ = false;
  net::SimulatedNetwork network_{3};
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::unique_ptr<FakeDriver>> drivers_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, device::DeviceId> ids_;
  Server server_{network_};
};

class Captures : public ::testing::TestWithParam<Recording> {};

TEST_P(Captures, are_answered_as_the_original_answered_them) {
  const std::filesystem::path base = reference() / "player/captures" / GetParam().name;
  Replay replay(GetParam(), read_file(base.string() + ".c2s"), read_file(base.string() + ".s2c"));
  replay.run();
}

INSTANTIATE_TEST_SUITE_P(
    Recorded, Captures,
    ::testing::Values(Recording{"01_raw_discovery"}, Recording{"02_raw_push_position2d"},
                      Recording{"03_raw_pull_mode"},
                      // Answered at once instead of never, or of when somebody opens the device.
                      Recording{"04_raw_errors", {{4}, {9}, {10}, {11, 9}, {12}, {14}, {15, 10}}},
                      Recording{"05_playerprint_position2d"}, Recording{"06_playerprint_defaults"},
                      Recording{"07_playerprop_getint"}, Recording{"08_playerprint_map_blocks"},
                      Recording{"10_cxxtest_position2d"}, Recording{"11_cxxtest_laser"},
                      Recording{"12_cxxtest_ranger"}, Recording{"13_raw_map"}, Recording{"14_raw_simulation"},
                      Recording{"15_raw_properties", {}, {{20, 0, "imgcmp"}, {51, 1, "tcpstream"}}},
                      Recording{"16_raw_ranger_gps_opaque", {}, {{13, 0, "dummy"}}},
                      // The newest data is kept, not the oldest, and the overflow says how much was lost.
                      Recording{"17_raw_overflow", {}, {{13, 5, "dummy"}}, 5},
                      Recording{"21_passthrough_server_as_client", {}, {{4, 0, "dummy"}}},
                      Recording{"22_playerv"}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace playhouse::server
