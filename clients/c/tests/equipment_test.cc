// Proxies of batteries, grippers, joints, lamps, blobfinders and radios.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fake_server.h"

namespace playhouse_c {
namespace {

using ::testing::ElementsAre;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Answers requests with `answer`, and the nth round with the nth of the data.
FakeServer::Script telling(const ph_message_type *message, std::vector<Bytes> data, Bytes answer = {}) {
  auto next = std::make_shared<std::size_t>(0);
  return script([=](Peer &peer, const Received &asked) {
    if (asked.header.kind == PH_KIND_CMD) return true;
    const bool round =
        asked.header.interface_code == PH_PLAYER_CODE && asked.header.subtype == PH_PLAYER_REQ_DATA->subtype;
    peer.answer(asked, round ? Bytes() : answer);
    if (!round) return true;
    peer.data(message, data.at((*next)++), 0, 2.5);
    peer.synch();
    return true;
  });
}

void read_one(const Client &client) {
  EXPECT_WORKS(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, &error));
}

/// The bodies of what was sent as one kind of message.
std::vector<Bytes> sent(FakeServer &server, const ph_message_type *message) {
  std::vector<Bytes> bodies;
  for (const Received &each : server.finish()) {
    if (each.header.interface_code == message->interface_code && each.header.kind == message->kind &&
        each.header.subtype == message->subtype) {
      bodies.push_back(each.body);
    }
  }
  return bodies;
}

TEST(Equipment, ABatteryTellsWhatTheServerReports) {
  const std::uint32_t some = PH_POWER_MASK_VOLTS | PH_POWER_MASK_CHARGING;
  const std::uint32_t others = PH_POWER_MASK_PERCENT | PH_POWER_MASK_JOULES | PH_POWER_MASK_WATTS;
  const auto data = [](const ph_power_data &told) { return body(ph_power_data_type, told); };
  FakeServer server(
      telling(PH_POWER_DATA_STATE, {data({some, 12.5F, 50, 10, 3, 1}), data({others, 12.5F, 50, 10, -3, 1}),
                                    data({some, 12, 0, 0, 0, -1})}));
  {
    const Client client = connected(server.address());
    ph_power *battery = ph_power_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
    ASSERT_NE(battery, nullptr);
    ph_battery_state state{};
    EXPECT_FAILS(ph_power_state(battery, &state, &error), PH_NO_DATA, "power:0 has sent no data yet");
    read_one(client);
    EXPECT_WORKS(ph_power_state(battery, &state, &error));
    EXPECT_EQ(state.volts, 12.5);
    EXPECT_EQ(state.charging, PH_CHARGING_YES);
    EXPECT_TRUE(std::isnan(state.percent) && std::isnan(state.joules) && std::isnan(state.watts));
    EXPECT_EQ(state.time, 2.5);
    read_one(client);
    EXPECT_WORKS(ph_power_state(battery, &state, &error));
    EXPECT_THAT((std::vector{state.percent, state.joules, state.watts}), ElementsAre(50, 10, -3));
    EXPECT_TRUE(std::isnan(state.volts));
    EXPECT_EQ(state.charging, PH_CHARGING_UNKNOWN);
    read_one(client);
    EXPECT_WORKS(ph_power_state(battery, &state, &error));
    EXPECT_EQ(state.charging, PH_CHARGING_IMPOSSIBLE);
    EXPECT_WORKS(ph_power_set_charging_policy(battery, true, false, &error));
  }
  EXPECT_THAT(sent(server, PH_POWER_REQ_SET_CHARGING_POLICY),
              ElementsAre(body(ph_power_chargepolicy_config_type, ph_power_chargepolicy_config{1, 0})));
}

TEST(Equipment, AGripperOpensAndClosesAndTellsWhatItDoes) {
  const auto data = [](const ph_gripper_data &told) { return body(ph_gripper_data_type, told); };
  const ph_gripper_geom geom = {{0.25, 0, 0.1, 0, 0, 0.5}, {0.1, 0.2, 0.3}, {0.05, 0.1, 0.15}, 2, 0};
  FakeServer server(telling(PH_GRIPPER_DATA_STATE,
                            {data({PH_GRIPPER_STATE_OPEN, 8, 0}), data({PH_GRIPPER_STATE_MOVING, 0, 0}),
                             data({PH_GRIPPER_STATE_ERROR, 4, 0})},
                            body(ph_gripper_geom_type, geom)));
  {
    const Client client = connected(server.address());
    ph_gripper *hand = ph_gripper_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
    ASSERT_NE(hand, nullptr);
    const auto told = [&] {
      ph_fingers_state state{};
      read_one(client);
      EXPECT_WORKS(ph_gripper_state(hand, &state, &error));
      return std::vector<int>{state.open, state.closed, state.moving, static_cast<int>(state.beams)};
    };
    EXPECT_THAT(told(), ElementsAre(1, 0, 0, 8));
    EXPECT_THAT(told(), ElementsAre(0, 0, 1, 0));
    EXPECT_THAT(told(), ElementsAre(0, 0, 0, 4));
    ph_fingers_geometry geometry{};
    EXPECT_WORKS(ph_gripper_geometry(hand, &geometry, &error));
    EXPECT_EQ(geometry.pose.yaw, 0.5);
    EXPECT_THAT((std::vector{geometry.size.x, geometry.size.y, geometry.gap.x}), ElementsAre(0.2, 0.1, 0.1));
    EXPECT_EQ(geometry.beam_count, 2U);
    EXPECT_WORKS(ph_gripper_open_fingers(hand, &error));
    EXPECT_WORKS(ph_gripper_close_fingers(hand, &error));
    EXPECT_WORKS(ph_gripper_stop(hand, &error));
  }
  std::vector<int> commands;
  for (const Received &each : server.finish()) {
    if (each.header.kind == PH_KIND_CMD) commands.push_back(each.header.subtype);
  }
  EXPECT_THAT(commands, ElementsAre(PH_GRIPPER_CMD_OPEN->subtype, PH_GRIPPER_CMD_CLOSE->subtype,
                                    PH_GRIPPER_CMD_STOP->subtype));
}

TEST(Equipment, AnArmHasSeveralJoints) {
  const ph_actarray_actuator actuators[] = {{1, 0.5F, 0.25F, 2, PH_ACTARRAY_ACTSTATE_MOVING},
                                            {2, 0, 0, -1, PH_ACTARRAY_ACTSTATE_BRAKED}};
  const ph_actarray_actuatorgeom turns = {
      PH_ACTARRAY_TYPE_ROTARY, 0.5F, {0.1, 0.2, 0.3}, {0, 0, 1}, -1, 0, 1, 0.25F, 2, 1};
  const ph_actarray_geom geom = {&turns, 1, {1, 2, 3}, {0.5, 0.25, 0.125}};
  FakeServer server(telling(PH_ACTARRAY_DATA_STATE,
                            {body(ph_actarray_data_type, ph_actarray_data{actuators, 2, 1})},
                            body(ph_actarray_geom_type, geom)));
  const Client client = connected(server.address());
  ph_actarray *arm = ph_actarray_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
  ASSERT_NE(arm, nullptr);
  read_one(client);
  ph_act_array_state state{};
  EXPECT_WORKS(ph_actarray_state(arm, &state, &error));
  EXPECT_TRUE(state.motors_on);
  ASSERT_EQ(state.joints_count, 2U);
  const ph_joint *joints = state.joints;
  EXPECT_THAT((std::vector{joints[0].position, joints[0].speed, joints[0].acceleration, joints[0].current}),
              ElementsAre(1, 0.5, 0.25, 2));
  EXPECT_TRUE(joints[0].moving && !joints[0].braked && !joints[0].stalled);
  EXPECT_TRUE(joints[1].braked && !joints[1].moving && std::isnan(joints[1].current));
  ph_act_array_geometry geometry{};
  EXPECT_WORKS(ph_actarray_geometry(arm, &geometry, &error));
  EXPECT_THAT((std::vector{geometry.pose.x, geometry.pose.z, geometry.pose.roll, geometry.pose.yaw}),
              ElementsAre(1, 3, 0.5, 0.125));
  ASSERT_EQ(geometry.joints_count, 1U);
  const ph_joint_geometry &joint = geometry.joints[0];
  EXPECT_TRUE(joint.rotary && joint.has_brakes);
  EXPECT_THAT(joint.axis, ElementsAre(0, 0, 1));
  EXPECT_THAT(joint.orientation, ElementsAre(0.1, 0.2, 0.3));
  EXPECT_THAT((std::vector{joint.length, joint.lowest, joint.centre, joint.highest, joint.home, joint.speed}),
              ElementsAre(0.5, -1, 0, 1, 0.25, 2));
  EXPECT_EQ(state.joints[1].position, 2) << "the joints of the geometry are in memory of their own";
}

TEST(Equipment, AnArmIsToldWhereToMoveAndHowFast) {
  FakeServer server(telling(PH_ACTARRAY_DATA_STATE, {}));
  {
    const Client client = connected(server.address());
    ph_actarray *arm = ph_actarray_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
    ASSERT_NE(arm, nullptr);
    const double positions[] = {0.5, 1.5}, speeds[] = {0.25}, infinite[] = {0.5, kInfinity}, large[] = {1e39};
    EXPECT_WORKS(ph_actarray_move_to(arm, 1, 0.5, &error));
    EXPECT_WORKS(ph_actarray_move_all_to(arm, positions, 2, &error));
    EXPECT_WORKS(ph_actarray_move_at(arm, 1, -0.5, &error));
    EXPECT_WORKS(ph_actarray_move_all_at(arm, speeds, 1, &error));
    EXPECT_WORKS(ph_actarray_home(arm, PH_ACTARRAY_ALL, &error));
    EXPECT_WORKS(ph_actarray_set_speed(arm, PH_ACTARRAY_ALL, 0.125, &error));
    EXPECT_WORKS(ph_actarray_set_motor_power(arm, false, &error));
    EXPECT_WORKS(ph_actarray_set_brakes(arm, true, &error));
    EXPECT_FAILS(ph_actarray_move_to(arm, -1, 1, &error), PH_INVALID_VALUE,
                 "actarray:0: joint is -1, not a whole number from 0 to 2147483647");
    EXPECT_FAILS(ph_actarray_move_to(arm, 0, kNan, &error), PH_INVALID_VALUE, "actarray:0: position is nan");
    EXPECT_FAILS(ph_actarray_move_all_to(arm, infinite, 2, &error), PH_INVALID_VALUE, "position is inf");
    EXPECT_FAILS(ph_actarray_move_all_at(arm, large, 1, &error), PH_WIRE_ERROR, "too large for the wire");
  }
  const float positions[] = {0.5F, 1.5F}, speed = 0.25F;
  EXPECT_THAT(sent(server, PH_ACTARRAY_CMD_POS),
              ElementsAre(body(ph_actarray_position_cmd_type, ph_actarray_position_cmd{1, 0.5F})));
  EXPECT_THAT(
      sent(server, PH_ACTARRAY_CMD_MULTI_POS),
      ElementsAre(body(ph_actarray_multi_position_cmd_type, ph_actarray_multi_position_cmd{positions, 2})));
  EXPECT_THAT(sent(server, PH_ACTARRAY_CMD_SPEED),
              ElementsAre(body(ph_actarray_speed_cmd_type, ph_actarray_speed_cmd{1, -0.5F})));
  EXPECT_THAT(sent(server, PH_ACTARRAY_CMD_MULTI_SPEED),
              ElementsAre(body(ph_actarray_multi_speed_cmd_type, ph_actarray_multi_speed_cmd{&speed, 1})));
  EXPECT_THAT(sent(server, PH_ACTARRAY_CMD_HOME),
              ElementsAre(body(ph_actarray_home_cmd_type, ph_actarray_home_cmd{-1})));
  EXPECT_THAT(sent(server, PH_ACTARRAY_REQ_SPEED),
              ElementsAre(body(ph_actarray_speed_config_type, ph_actarray_speed_config{-1, 0.125F})));
  EXPECT_THAT(sent(server, PH_ACTARRAY_REQ_POWER),
              ElementsAre(body(ph_actarray_power_config_type, ph_actarray_power_config{0})));
  EXPECT_THAT(sent(server, PH_ACTARRAY_REQ_BRAKES),
              ElementsAre(body(ph_actarray_brakes_config_type, ph_actarray_brakes_config{1})));
}

TEST(Equipment, ALampIsSwitchedColoredAndMadeToFlash) {
  FakeServer server(
      telling(PH_BLINKENLIGHT_DATA_STATE,
              {body(ph_blinkenlight_data_type, ph_blinkenlight_data{1, 1.5F, 0.5F, {0, 1, 2, 3}})}));
  {
    const Client client = connected(server.address());
    ph_blinkenlight *lamp = ph_blinkenlight_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
    ASSERT_NE(lamp, nullptr);
    read_one(client);
    ph_light_state state{};
    EXPECT_WORKS(ph_blinkenlight_state(lamp, &state, &error));
    EXPECT_TRUE(state.on);
    EXPECT_EQ(state.period, 1.5);
    EXPECT_EQ(state.duty_cycle, 0.5);
    EXPECT_THAT(state.color, ElementsAre(1, 2, 3));
    const std::uint8_t one[] = {4, 5, 6}, other[] = {7, 8, 9};
    EXPECT_WORKS(ph_blinkenlight_set_power(lamp, false, 0, &error));
    EXPECT_WORKS(ph_blinkenlight_set_color(lamp, one, 3, &error));
    EXPECT_WORKS(ph_blinkenlight_flash(lamp, 2, 0.5, 0, &error));
    EXPECT_WORKS(ph_blinkenlight_set(lamp, true, 1, 0.25, other, 0, &error));
    EXPECT_FAILS(ph_blinkenlight_flash(lamp, kNan, 0.5, 0, &error), PH_INVALID_VALUE, "period is nan");
  }
  EXPECT_THAT(sent(server, PH_BLINKENLIGHT_CMD_POWER),
              ElementsAre(body(ph_blinkenlight_cmd_power_type, ph_blinkenlight_cmd_power{0, 0})));
  EXPECT_THAT(
      sent(server, PH_BLINKENLIGHT_CMD_COLOR),
      ElementsAre(body(ph_blinkenlight_cmd_color_type, ph_blinkenlight_cmd_color{3, {255, 4, 5, 6}})));
  EXPECT_THAT(sent(server, PH_BLINKENLIGHT_CMD_FLASH),
              ElementsAre(body(ph_blinkenlight_cmd_flash_type, ph_blinkenlight_cmd_flash{0, 2, 0.5F})));
  EXPECT_THAT(
      sent(server, PH_BLINKENLIGHT_CMD_STATE),
      ElementsAre(body(ph_blinkenlight_cmd_type, ph_blinkenlight_cmd{0, 1, 1, 0.25F, {255, 7, 8, 9}})));
}

TEST(Equipment, ABlobHasAColorOfThreeBytes) {
  const ph_blobfinder_blob blob = {4, 0x123456, 12, 1, 2, 3, 4, 5, 6, 0.5F};
  FakeServer server(telling(PH_BLOBFINDER_DATA_BLOBS,
                            {body(ph_blobfinder_data_type, ph_blobfinder_data{160, 120, &blob, 1})}));
  const Client client = connected(server.address());
  ph_blobfinder *eye = ph_blobfinder_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
  ASSERT_NE(eye, nullptr);
  read_one(client);
  ph_image_size size{};
  EXPECT_WORKS(ph_blobfinder_image_size(eye, &size, &error));
  EXPECT_EQ(size.width, 160U);
  EXPECT_EQ(size.height, 120U);
  const ph_blob *blobs = nullptr;
  std::size_t count = 0;
  EXPECT_WORKS(ph_blobfinder_blobs(eye, &blobs, &count, &error));
  ASSERT_EQ(count, 1U);
  EXPECT_THAT(blobs->color, ElementsAre(0x12, 0x34, 0x56));
  EXPECT_THAT((std::vector{blobs->channel, blobs->area, blobs->x, blobs->y, blobs->left, blobs->right,
                           blobs->top, blobs->bottom}),
              ElementsAre(4, 12, 1, 2, 3, 4, 5, 6));
  EXPECT_EQ(blobs->range, 0.5);
}

TEST(Equipment, LevelsOfARadioAreSignedInDbm) {
  const std::uint8_t mac[] = {'a', ':', 'b', 0, 'x'}, ip[] = {'1', '.', '2'}, own[] = {'c', ':', 'd'};
  const ph_wifi_link link = {mac, 5, ip, 3, nullptr, 0, PH_WIFI_MODE_INFRA, 2412, 1, 40, -48, -100};
  ph_wifi_data data = {&link, 1, 1, 2, PH_WIFI_MODE_INFRA, PH_WIFI_QUAL_DBM, 70, -48, -100, "cc"};
  ph_wifi_data relative = data;
  relative.qual_type = PH_WIFI_QUAL_REL;
  FakeServer server(telling(PH_WIFI_DATA_STATE,
                            {body(ph_wifi_data_type, data), body(ph_wifi_data_type, relative)},
                            body(ph_wifi_mac_req_type, ph_wifi_mac_req{own, 3})));
  const Client client = connected(server.address());
  ph_wifi *radio = ph_wifi_open(client.get(), 0, PH_ACCESS_ALL, nullptr);
  ASSERT_NE(radio, nullptr);
  char address[33];
  EXPECT_WORKS(ph_wifi_mac(radio, address, &error));
  EXPECT_STREQ(address, "c:d");
  read_one(client);
  ph_radio_state state{};
  EXPECT_WORKS(ph_wifi_state(radio, &state, &error));
  ASSERT_EQ(state.links_count, 1U);
  EXPECT_STREQ(state.links[0].mac, "a:b");
  EXPECT_STREQ(state.links[0].ip, "1.2");
  EXPECT_STREQ(state.links[0].essid, "");
  EXPECT_TRUE(state.links[0].encrypted);
  EXPECT_THAT((std::vector{state.links[0].level, state.links[0].noise, state.max_level, state.max_noise}),
              ElementsAre(-48, -100, -48, -100));
  EXPECT_THAT((std::vector{state.throughput, state.bitrate, state.mode, state.unit, state.max_quality,
                           state.links[0].frequency, state.links[0].quality}),
              ElementsAre(1, 2, PH_WIFI_MODE_INFRA, PH_WIFI_QUAL_DBM, 70, 2412, 40));
  EXPECT_STREQ(state.access_point, "cc");
  read_one(client);
  EXPECT_WORKS(ph_wifi_state(radio, &state, &error));
  EXPECT_EQ(state.links[0].level, (std::int64_t{1} << 32) - 48);
}

}  // namespace
}  // namespace playhouse_c
