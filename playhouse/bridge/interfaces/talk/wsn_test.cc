// What a mote and a base station tell, and what clients may ask of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/wsn.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
namespace wsn = wire::wsn;

constexpr const char* kWorld = R"(
interval_sim 100
mote( name "base" base 1 node_id 7 )
mote( name "a" node_type 3 node_id 40 )
mote( name "b" node_id 41 awake 0 )
mote( name "c" group 2 )
)";

class WsnDevice : public testing::OneDevice {
 protected:
  WsnDevice() : OneDevice(kWorld) {}

  world::Motes& motes() { return still_.world().motes; }
  /// Readings of a mote, reported in the next tick.
  void measure(world::MoteRow mote) {
    motes().acceleration[mote] = {0, -19.6133, 9.80665};
    motes().temperature[mote] = 22.5;
    motes().volts[mote] = 1.5;
    motes().reported_tick[mote] = still_.world().tick() + 1;
  }
  bool set_power(std::int32_t node, std::int32_t group, std::uint8_t value) {
    return ask_with(wsn::kReqPower, wsn::PowerConfig{node, group, value}).ack;
  }
  bool set_rate(std::int32_t node, std::int32_t group, double frequency) {
    return ask_with(wsn::kReqDatafreq, wsn::DatafreqConfig{node, group, frequency}).ack;
  }
  bool set_type(std::uint8_t value) { return ask_with(wsn::kReqDatatype, wsn::DatatypeConfig{value}).ack; }
};

TEST_F(WsnDevice, a_mote_tells_its_own_readings_once) {
  open(wsn::kCode, "a");
  measure({1});
  still_.run(2);
  EXPECT_EQ(count(wsn::kDataState), 1);
  const auto data = last<wsn::Data>(wsn::kDataState);
  EXPECT_EQ(data.node_type, 3u);
  EXPECT_EQ(data.node_id, 40u);
  EXPECT_EQ(data.node_parent_id, 40u);
  EXPECT_FLOAT_EQ(data.data_packet.temperature, 22.5f);
  EXPECT_FLOAT_EQ(data.data_packet.battery, 1.5f);
  EXPECT_FLOAT_EQ(data.data_packet.accel_y, -19.6133f);
  EXPECT_EQ(data.data_packet.light, -1);
  EXPECT_EQ(data.data_packet.mic, -1);
  EXPECT_EQ(data.data_packet.magn_x, 0);
}

TEST_F(WsnDevice, a_base_station_tells_those_it_heard_and_no_others) {
  open(wsn::kCode, "base");
  for (const std::uint32_t mote : {0u, 1u, 2u, 3u}) measure({mote});
  motes().links[{0}] = {{{1}, -50, 1}, {{2}, -60, 0}, {{77}, -60, 1}};
  still_.run(1);
  EXPECT_EQ(count(wsn::kDataState), 1);
  const auto data = last<wsn::Data>(wsn::kDataState);
  EXPECT_EQ(data.node_id, 40u);
  EXPECT_EQ(data.node_parent_id, 7u);
}

TEST_F(WsnDevice, without_an_id_a_mote_has_that_of_its_model) {
  open(wsn::kCode, "c");
  measure({3});
  still_.run(1);
  EXPECT_EQ(last<wsn::Data>(wsn::kDataState).node_id, 4u);
}

TEST_F(WsnDevice, raw_readings_are_counts_of_a_converter_until_the_last_client_closes_it) {
  open(wsn::kCode, "a");
  EXPECT_TRUE(set_type(0));
  measure({1});
  still_.run(1);
  const wsn::NodeData raw = last<wsn::Data>(wsn::kDataState).data_packet;
  EXPECT_EQ(raw.accel_x, 512) << "half of 1023";
  EXPECT_EQ(raw.accel_y, 0);
  EXPECT_EQ(raw.temperature, 512) << "in the middle of -40 and 85 degC";
  EXPECT_EQ(raw.battery, 512) << "half of 3 V";
  EXPECT_FALSE(set_type(2));
  EXPECT_TRUE(set_type(1));
  EXPECT_TRUE(set_type(0));
  reopen();
  measure({1});
  still_.run(1);
  EXPECT_FLOAT_EQ(last<wsn::Data>(wsn::kDataState).data_packet.temperature, 22.5f);
}

TEST_F(WsnDevice, a_base_station_commands_motes_in_reach_by_their_ids_and_groups) {
  open(wsn::kCode, "base");
  still_.run(1);
  motes().links[{0}] = {{{1}, -50, 1}, {{2}, -60, 0}};
  EXPECT_THAT(motes().awake, ElementsAre(1, 1, 0, 1));
  EXPECT_TRUE(set_power(-1, -1, 0));
  EXPECT_THAT(motes().awake, ElementsAre(1, 0, 0, 1)) << "not itself, nor who is out of reach";
  EXPECT_TRUE(set_power(41, 0, 1));
  EXPECT_THAT(motes().awake, ElementsAre(1, 0, 1, 1));
  EXPECT_TRUE(set_rate(40, -1, 2.5));
  EXPECT_THAT(motes().frequency, ElementsAre(0, 2.5, 0, 0));
  EXPECT_FALSE(set_power(4, -1, 0)) << "out of reach";
  EXPECT_FALSE(set_power(-1, 2, 0)) << "none of that group";
  EXPECT_FALSE(set_power(-1, -1, 2));
  EXPECT_FALSE(set_rate(-1, -1, -1));
  EXPECT_FALSE(set_rate(-1, -1, NAN));
}

TEST_F(WsnDevice, a_base_station_that_has_just_been_opened_answers_after_the_next_tick) {
  open(wsn::kCode, "base");
  const std::vector<std::byte> body = wire::encode(wsn::PowerConfig{-1, -1, 0});
  const auto send = [&](std::uint64_t ticket) {
    driver_.request({kId, static_cast<std::uint8_t>(wire::MessageType::kReq), wsn::kReqPower, body},
                    device::Replier(still_.recorder, ticket));
    still_.run(0);
    return still_.recorder.answers.contains(ticket);
  };
  motes().measured_tick[{0}] = 0;
  EXPECT_FALSE(send(71));
  motes().links[{0}] = {{{1}, -50, 0}};  // what the tick will measure
  still_.run(1);
  still_.run(0);
  EXPECT_TRUE(still_.recorder.answers[71].ack);
  EXPECT_THAT(motes().awake, ElementsAre(1, 0, 0, 1));
  motes().measured_tick[{0}] = 0;
  EXPECT_FALSE(send(72));
  driver_.stop(kId);
  still_.run(0);
  ASSERT_TRUE(still_.recorder.answers.contains(72)) << "it is closed before that";
  EXPECT_FALSE(still_.recorder.answers[72].ack);
}

TEST_F(WsnDevice, what_the_next_client_selects_is_not_reset_by_the_end_of_the_one_before) {
  open(wsn::kCode, "a");
  driver_.stop(kId);
  ASSERT_TRUE(driver_.start(kId));
  EXPECT_TRUE(set_type(0)) << "all of it between the same two ticks";
  measure({1});
  still_.run(1);
  EXPECT_EQ(last<wsn::Data>(wsn::kDataState).data_packet.battery, 512);
}

TEST_F(WsnDevice, any_other_mote_commands_itself_alone) {
  open(wsn::kCode, "a");
  EXPECT_TRUE(set_power(-1, -1, 0));
  EXPECT_THAT(motes().awake, ElementsAre(1, 0, 0, 1));
  EXPECT_FALSE(set_power(41, -1, 1));
}

/// More motes than a client can be owed messages, and their base station.
class ManyMotes : public testing::OneDevice {
 protected:
  static constexpr std::uint32_t kMotes = limits::kSessionQueueMessages + 476;

  ManyMotes() : OneDevice(world()) {}
  static std::string world() {
    std::string text = "interval_sim 100\nmote( name \"base\" base 1 )\n";
    for (std::uint32_t k = 0; k < kMotes; ++k) text += "mote()\n";
    return text;
  }
};

TEST_F(ManyMotes, are_told_in_turn) {
  open(wsn::kCode, "base");
  for (std::uint32_t k = 1; k <= kMotes; ++k) still_.world().motes.links[{0}].push_back({{k}, -50, 1});
  still_.run(1);
  EXPECT_EQ(count(wsn::kDataState), std::ptrdiff_t{limits::kSessionQueueMessages});
  still_.run(1);
  std::vector<int> told(kMotes + 2);
  for (const device::Publication& each : still_.recorder.published)
    ++told[wire::decode<wsn::Data>(each.body)->node_id];
  EXPECT_THAT(std::span(told).subspan(2), ::testing::Each(::testing::Ge(1)));
}

}  // namespace
}  // namespace playhouse::drivers
