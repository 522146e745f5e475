#include "playhouse/drivers/dummy/dummy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/grid_map/testing_tiles.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {
namespace {

namespace p2d = wire::position2d;
using ::testing::HasSubstr;

constexpr std::uint8_t kCmd = 2, kReq = 3;

/// A site with a device of every interface, of index 3.
struct All {
  testing::MemorySite site{""};
  std::uint64_t tickets = 0;

  explicit All(const std::string& fields = "") {
    std::string provides;
    for (const wire::InterfaceDef& interf : wire::interfaces())
      if (interf.code != wire::player::kCode) provides += " \"" + std::string(interf.name) + ":3\"";
    EXPECT_EQ(site.build("driver( name \"dummy\" provides [" + provides + " ] " + fields + " )"), "");
  }
  device::DeviceId id(std::uint16_t interf) const { return site.id({6665, interf, 3}); }
  device::Driver& driver(std::uint16_t interf) const { return site.driver({6665, interf, 3}); }
  testing::OutputRecorder::RecordedAnswer ask(std::uint16_t interf, std::uint8_t subtype, const Bytes& body) {
    driver(interf).request({id(interf), kReq, subtype, body}, device::Replier(site.recorder, ++tickets));
    return site.recorder.answers.at(tickets);
  }
  void run_for(double seconds) { static_cast<net::SimulatedNetwork&>(site.network()).run_for(seconds); }
};

template <typename F>
void each_message(wire::MessageType type, F f) {
  for (const wire::InterfaceDef& interf : wire::interfaces())
    if (interf.code != wire::player::kCode)
      for (const wire::MessageDef& message : interf.messages)
        if (message.type == type) f(interf.code, message);
}

TEST(Dummy, sends_every_data_message_of_every_interface_at_its_rate) {
  All all("rate 20");
  for (const wire::InterfaceDef& interf : wire::interfaces()) {
    if (interf.code == wire::player::kCode) continue;
    ASSERT_TRUE(all.site.hold(all.id(interf.code)).ok());
  }
  EXPECT_TRUE(all.site.recorder.published.empty());  // nobody hears of it yet
  all.run_for(0.99);
  std::map<std::pair<std::uint32_t, std::uint8_t>, std::vector<Bytes>> sent;
  for (const device::Publication& data : all.site.recorder.published)
    sent[{data.device.row, data.subtype}].push_back(data.body);
  std::size_t kinds = 0;
  each_message(wire::MessageType::kData, [&](std::uint16_t interf, const wire::MessageDef& message) {
    ++kinds;
    const Plausible values(0, {6665, interf, 3});
    const std::vector<Bytes>& bodies = sent[{all.id(interf).row, message.subtype}];
    ASSERT_EQ(bodies.size(), 20u) << message.name;
    for (std::size_t number = 0; number < bodies.size(); ++number) {
      EXPECT_EQ(bodies[number], values.body(message, number)) << message.name;
      EXPECT_EQ(message.check(bodies[number]), "") << message.name;
    }
  });
  EXPECT_EQ(sent.size(), kinds);
}

TEST(Dummy, sends_while_it_is_open_and_begins_anew_when_it_is_opened_again) {
  All all("rate 0.5 seed 9");
  const device::DeviceId robot = all.id(p2d::kCode);
  const wire::MessageDef& state = *wire::find_message(p2d::kCode, wire::MessageType::kData, p2d::kDataState);
  const auto states = [&] {
    std::vector<Bytes> bodies;
    for (device::Publication& data : std::exchange(all.site.recorder.published, {}))
      if (data.subtype == p2d::kDataState) bodies.push_back(std::move(data.body));
    return bodies;
  };
  all.run_for(10);
  EXPECT_TRUE(states().empty());
  const Plausible values(9, {6665, p2d::kCode, 3});
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(all.site.hold(robot).ok());
    all.run_for(5);
    EXPECT_EQ(states(),
              (std::vector<Bytes>{values.body(state, 0), values.body(state, 1), values.body(state, 2)}));
    all.site.release(robot);
    all.run_for(5);
    EXPECT_TRUE(states().empty());
  }
}

TEST(Dummy, answers_every_request_without_a_body_with_its_payload) {
  All all;
  each_message(wire::MessageType::kReq, [&](std::uint16_t interf, const wire::MessageDef& message) {
    const auto [ack, body] = all.ask(interf, message.subtype, {});
    ASSERT_TRUE(ack) << message.name;
    EXPECT_EQ(message.check(body), "") << message.name;
    EXPECT_EQ(body, Plausible(0, {6665, interf, 3}).body(message, 0)) << message.name;
    EXPECT_TRUE(all.driver(interf).capable(all.id(interf), kReq, message.subtype)) << message.name;
  });
}

TEST(Dummy, remembers_what_is_set) {
  int set = 0, asked = 0;
  each_message(wire::MessageType::kReq, [&](std::uint16_t interf, const wire::MessageDef& message) {
    const bool is_for_a_name = message.payload == "map::Data" || message.payload == "simulation::PropertyReq";
    if (!message.has_payload || is_for_a_name) return;
    All all;
    const Bytes other = Plausible(77, {6665, interf, 3}).body(message, 0);
    const auto answer = all.ask(interf, message.subtype, other);
    ASSERT_TRUE(answer.ack) << message.name;
    const Bytes now = all.ask(interf, message.subtype, {}).body;
    EXPECT_EQ(answer.body, now) << message.name;
    const bool is_question = message.name.find(".get_") != std::string_view::npos;
    if (is_question) {
      ++asked;
      EXPECT_EQ(now, Plausible(0, {6665, interf, 3}).body(message, 0)) << message.name << " sets nothing";
    }
    if (message.name.find(".set_") == std::string_view::npos) return;
    ++set;
    EXPECT_EQ(now, other) << message.name;
    // Also for other requests of the payload.
    for (const wire::MessageDef& question : wire::find_interface(interf)->messages)
      if (question.type == wire::MessageType::kReq && question.payload == message.payload)
        EXPECT_EQ(all.ask(interf, question.subtype, {}).body, other) << question.name;
  });
  EXPECT_GT(set, 15);
  EXPECT_GT(asked, 15);
}

TEST(Dummy, gives_the_cells_that_are_asked_for) {
  All all;
  namespace map = wire::map;
  const Bytes body = all.ask(map::kCode, map::kReqGetInfo, {}).body;
  EXPECT_EQ(wire::decode<map::Info>(body)->width, 40u);
  const auto tile = all.ask(map::kCode, map::kReqGetData, wire::encode(map::Data{0, 0, 3, 2, 0, {}}));
  ASSERT_TRUE(tile.ack);
  EXPECT_THAT(unpacked(*wire::decode<map::Data>(tile.body)), ::testing::ElementsAre(1, 1, 1, 1, -1, -1));
  EXPECT_FALSE(all.ask(map::kCode, map::kReqGetData, wire::encode(map::Data{1, 0, 40, 1, 0, {}})).ack);
}

TEST(Dummy, has_properties_of_all_types_once_they_are_set) {
  All all;
  const auto expect_kept = [&](std::uint8_t get, std::uint8_t to_set, const Bytes& question,
                               const Bytes& value) {
    EXPECT_FALSE(all.ask(p2d::kCode, get, question).ack);
    EXPECT_EQ(all.ask(p2d::kCode, to_set, value).body, value);
    EXPECT_EQ(all.ask(p2d::kCode, get, question).body, value);
    EXPECT_FALSE(all.ask(wire::opaque::kCode, get, question).ack);  // of another device
    EXPECT_FALSE(all.ask(p2d::kCode, get, {}).ack);
  };
  const std::string key = wire::c_string("gain"), no_nul = "gain";
  using wire::encode;
  expect_kept(wire::kReqGetBoolprop, wire::kReqSetBoolprop, encode(wire::BoolpropReq{no_nul, 0}),
              encode(wire::BoolpropReq{key, 1}));
  expect_kept(wire::kReqGetIntprop, wire::kReqSetIntprop, encode(wire::IntpropReq{key, 0}),
              encode(wire::IntpropReq{key, -7}));
  expect_kept(wire::kReqGetDblprop, wire::kReqSetDblprop, encode(wire::DblpropReq{key, 0}),
              encode(wire::DblpropReq{key, 0.5}));
  expect_kept(wire::kReqGetStrprop, wire::kReqSetStrprop, encode(wire::StrpropReq{key, {}}),
              encode(wire::StrpropReq{key, wire::c_string("fast")}));

  namespace sim = wire::simulation;
  const auto of_model = [](const std::string& model, const std::string& property, const std::string& value) {
    return encode(sim::PropertyReq{wire::c_string(model), wire::c_string(property), 0, value});
  };
  // As of a server without a list of models, which clients ask for.
  EXPECT_FALSE(all.ask(sim::kCode, sim::kReqGetProperty, of_model("", "models", "")).ack);
  const Bytes red = of_model("r0", "color", "red");
  EXPECT_EQ(all.ask(sim::kCode, sim::kReqSetProperty, red).body, red);
  EXPECT_EQ(all.ask(sim::kCode, sim::kReqGetProperty, of_model("r0", "color", "")).body, red);
  EXPECT_FALSE(all.ask(sim::kCode, sim::kReqGetProperty, of_model("r1", "color", "")).ack);
  EXPECT_FALSE(all.ask(sim::kCode, sim::kReqGetProperty, of_model("", "models", "")).ack);
}

TEST(Dummy, remembers_no_more_than_its_limit) {
  All all;
  const auto set = [&](std::size_t bytes) {
    const wire::opaque::Data data{std::vector<std::uint8_t>(bytes)};
    return all.ask(wire::opaque::kCode, wire::opaque::kReqData, wire::encode(data)).ack;
  };
  EXPECT_TRUE(set(limits::kDummyBytes / 2));
  EXPECT_FALSE(set(limits::kDummyBytes));
  EXPECT_TRUE(set(limits::kDummyBytes - 1024)) << "it replaces the first one";
  const auto property = [&](const std::string& key) {
    return all.ask(wire::opaque::kCode, wire::kReqSetIntprop, wire::encode(wire::IntpropReq{key, 1})).ack;
  };
  EXPECT_TRUE(property("a"));
  EXPECT_TRUE(property("b"));
  EXPECT_FALSE(property("c"));
  EXPECT_TRUE(property("a")) << "it is there already";
  EXPECT_TRUE(set(4));
  EXPECT_TRUE(property("c"));
}

TEST(Dummy, takes_every_command_that_can_be_decoded) {
  All all;
  int commands = 0;
  each_message(wire::MessageType::kCmd, [&](std::uint16_t interf, const wire::MessageDef& message) {
    const Bytes body = Plausible(0, {6665, interf, 3}).body(message, 0);
    EXPECT_EQ(all.driver(interf).command({all.id(interf), kCmd, message.subtype, body}),
              device::Taken::kLatest)
        << message.name;
    EXPECT_TRUE(all.driver(interf).capable(all.id(interf), kCmd, message.subtype));
    if (message.has_payload)
      EXPECT_EQ(all.driver(interf).command({all.id(interf), kCmd, message.subtype, {}}), device::Taken::kNo);
    ++commands;
  });
  EXPECT_GT(commands, 40);
  EXPECT_EQ(all.driver(p2d::kCode).command({all.id(p2d::kCode), kCmd, 99, {}}), device::Taken::kNo);
  EXPECT_FALSE(all.driver(p2d::kCode).capable(all.id(p2d::kCode), kReq, 99));
  EXPECT_FALSE(all.ask(p2d::kCode, 99, {}).ack);
}

TEST(Dummy, a_retired_device_sends_and_answers_nothing) {
  All all;
  const device::DeviceId robot = all.id(p2d::kCode);
  device::Driver& driver = all.driver(p2d::kCode);
  ASSERT_TRUE(all.site.hold(robot).ok());
  all.site.retire_device(robot);
  all.run_for(5);
  EXPECT_TRUE(all.site.recorder.published.empty());
  driver.request({robot, kReq, p2d::kReqGetGeom, {}}, device::Replier(all.site.recorder, 1));
  EXPECT_FALSE(all.site.recorder.answers.at(1).ack);
}

TEST(Dummy, timestamps_are_those_of_a_world_of_the_same_file) {
  testing::MemorySite site("interval_sim 100\nposition( name \"r0\" )");
  ASSERT_EQ(site.build("driver( name \"dummy\" provides [\"laser:0\" \"7000:laser:0\"] )\n"
                       "driver( name \"stage\" provides [\"simulation:0\"] worldfile \"some.world\" )"),
            "");
  site.run(12);
  ASSERT_TRUE(site.hold(site.id({7000, 6, 0})).ok());
  static_cast<net::SimulatedNetwork&>(site.network()).run_for(0.01);
  ASSERT_FALSE(site.recorder.published.empty());
  for (const device::Publication& data : site.recorder.published) EXPECT_DOUBLE_EQ(data.timestamp, 1.2);
}

TEST(Dummy, tells_what_is_wrong_with_a_section) {
  const auto fault = [](const std::string& provides, const std::string& fields) {
    return testing::MemorySite("").build("driver( name \"dummy\" provides [" + provides + "] " + fields +
                                         " )");
  };
  EXPECT_THAT(fault("\"laser:0\"", "rate 0.001"), HasSubstr("test.cfg:1: rate is 0.01 at least"));
  EXPECT_THAT(fault("\"laser:0\"", "rate 1001"), HasSubstr("test.cfg:1: rate is at most 1000"));
  EXPECT_THAT(fault("\"laser:0\"", "seed -1"), HasSubstr("test.cfg:1: seed is from 0 to "));
  EXPECT_THAT(fault("\"lasr:0\"", ""), HasSubstr("did you mean \"laser\"?"));
  EXPECT_THAT(fault("\"player:0\"", ""), HasSubstr("\"player:0\" is the server itself"));
  testing::MemorySite site("");
  ASSERT_EQ(site.build("driver( name \"dummy\" provides [\"laser:0\" \"laser:7\"] rat 5 )"), "");
  ASSERT_EQ(site.site().warnings().size(), 1u);
  EXPECT_THAT(site.site().warnings().front(), HasSubstr("did you mean \"rate\"?"));
}

}  // namespace
}  // namespace playhouse::drivers
