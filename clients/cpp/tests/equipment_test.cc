/// Proxies of batteries, grippers, joints, lamps, blobfinders and radios.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fake_server.h"
#include "playhouse_client/actarray.h"
#include "playhouse_client/blinkenlight.h"
#include "playhouse_client/blobfinder.h"
#include "playhouse_client/gripper.h"
#include "playhouse_client/power.h"
#include "playhouse_client/simulation.h"
#include "playhouse_client/wifi.h"
#include "testing_scripts.h"

namespace playhouse::client {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using wire::MessageType;

/// Data of a device with index 0, subtype 1, measured at `time` [s].
template <typename T>
void tell(Peer& peer, std::uint16_t interf, const T& value, double time = 2.5) {
  wire::Header header;
  header.interf = interf;
  header.subtype = 1;
  header.timestamp = time;
  peer.say(header, wire::encode(value));
}

/// One of the values in each round, and `answer` to requests of the device.
template <typename T>
FakeServer::Script telling(std::uint16_t interf, std::vector<T> values, std::vector<std::byte> answer = {}) {
  return rounds([=, next = std::size_t{0}](Peer& peer, const Received& message) mutable {
    if (message.header.type == MessageType::kCmd) return;
    const bool is_round = message.header.interf != interf;
    peer.answer(message, is_round ? std::vector<std::byte>() : answer);
    if (!is_round) return;
    tell(peer, interf, values.at(next++));
    peer.synch();
  });
}

/// Bodies of the commands or requests to a device, in order. Only after finish().
template <typename T>
std::vector<T> sent(const FakeServer& server, std::uint16_t interf, MessageType type, std::uint8_t subtype) {
  std::vector<T> bodies;
  for (const auto& [header, body] : server.received())
    if (header.interf == interf && header.type == type && header.subtype == subtype)
      bodies.push_back(*wire::decode<T>(body));
  return bodies;
}

TEST(Equipment, OfABatteryOnlyWhatIsValidIsTold) {
  namespace power = wire::power;
  const std::uint32_t some = power::kMaskVolts | power::kMaskCharging;
  const std::uint32_t others = power::kMaskPercent | power::kMaskJoules | power::kMaskWatts;
  FakeServer server(telling<power::Data>(
      power::kCode, {{some, 12.5f, 50, 10, 3, 1}, {others, 12.5f, 50, 10, -3, 1}, {some, 12, 0, 0, 0, -1}}));
  {
    Client client = connect(server);
    Result<Power> battery = Power::open(client, 0);
    ASSERT_TRUE(battery);
    EXPECT_FALSE(battery->state());
    ASSERT_TRUE(client.read());
    EXPECT_EQ(battery->state()->volts, 12.5);
    EXPECT_EQ(battery->state()->charging, Charging::kYes);
    EXPECT_FALSE(battery->state()->percent || battery->state()->joules || battery->state()->watts);
    EXPECT_EQ(battery->state()->time, 2.5);
    ASSERT_TRUE(client.read());
    EXPECT_EQ(battery->state()->percent, 50.0);
    EXPECT_EQ(battery->state()->joules, 10.0);
    EXPECT_EQ(battery->state()->watts, -3.0);
    EXPECT_FALSE(battery->state()->volts || battery->state()->charging);
    ASSERT_TRUE(client.read());
    EXPECT_EQ(battery->state()->charging, Charging::kImpossible);
    EXPECT_TRUE(battery->set_charging_policy(true, false));
  }
  server.finish();
  EXPECT_THAT(sent<power::ChargepolicyConfig>(server, power::kCode, MessageType::kReq, 1),
              ElementsAre(power::ChargepolicyConfig{1, 0}));
}

TEST(Equipment, AGripperOpensAndClosesAndTellsWhatItDoes) {
  namespace gripper = wire::gripper;
  const gripper::Geom geom{{0.25, 0, 0.1, 0, 0, 0.5}, {0.1, 0.2, 0.3}, {0.05, 0.1, 0.15}, 2, 0};
  FakeServer server(telling<gripper::Data>(
      gripper::kCode,
      {{gripper::kStateOpen, 8, 0}, {gripper::kStateMoving, 0, 0}, {gripper::kStateError, 4, 0}},
      wire::encode(geom)));
  {
    Client client = connect(server);
    Result<Gripper> hand = Gripper::open(client, 0);
    ASSERT_TRUE(hand);
    EXPECT_FALSE(hand->state());
    ASSERT_TRUE(client.read());
    EXPECT_TRUE(hand->state()->open && !hand->state()->closed && !hand->state()->moving);
    EXPECT_EQ(hand->state()->beams, 8u);
    ASSERT_TRUE(client.read());
    EXPECT_TRUE(hand->state()->moving && !hand->state()->open);
    ASSERT_TRUE(client.read());
    EXPECT_FALSE(hand->state()->open || hand->state()->closed || hand->state()->moving);
    const auto geometry = hand->geometry();
    ASSERT_TRUE(geometry);
    EXPECT_EQ(geometry->pose, (Pose3d{0.25, 0, 0.1, 0, 0, 0.5}));
    EXPECT_EQ(geometry->size, (Size{0.2, 0.1, 0.3}));
    EXPECT_EQ(geometry->gap, (Size{0.1, 0.05, 0.15}));
    EXPECT_EQ(geometry->beam_count, 2u);
    EXPECT_TRUE(hand->open_fingers() && hand->close_fingers() && hand->stop());
  }
  server.finish();
  std::vector<int> commands;
  for (const Received& message : server.received())
    if (message.header.type == MessageType::kCmd) commands.push_back(message.header.subtype);
  EXPECT_THAT(commands, ElementsAre(gripper::kCmdOpen, gripper::kCmdClose, gripper::kCmdStop));
}

TEST(Equipment, AnArmHasSeveralJoints) {
  namespace act = wire::actarray;
  const act::Data told{{{1, 0.5f, 0.25f, 2, act::kActstateMoving}, {2, 0, 0, -1, act::kActstateBraked}}, 1};
  const act::Geom geom{{{act::kTypeRotary, 0.5f, {0.1, 0.2, 0.3}, {0, 0, 1}, -1, 0, 1, 0.25f, 2, 1}},
                       {1, 2, 3},
                       {0.5, 0.25, 0.125}};
  FakeServer server(telling<act::Data>(act::kCode, {told}, wire::encode(geom)));
  {
    Client client = connect(server);
    Result<ActArray> arm = ActArray::open(client, 0);
    ASSERT_TRUE(arm);
    EXPECT_FALSE(arm->state());
    EXPECT_THAT(arm->joints(), IsEmpty());
    ASSERT_TRUE(client.read());
    const std::vector<Joint> joints = arm->joints();
    ASSERT_EQ(joints.size(), 2u);
    EXPECT_TRUE(arm->state()->motors_on);
    EXPECT_EQ(joints[0].position, 1);
    EXPECT_EQ(joints[0].speed, 0.5);
    EXPECT_EQ(joints[0].acceleration, 0.25);
    EXPECT_EQ(joints[0].current, 2.0);
    EXPECT_TRUE(joints[0].moving && !joints[0].braked && !joints[0].stalled);
    EXPECT_FALSE(joints[1].current);
    EXPECT_TRUE(joints[1].braked && !joints[1].moving);
    const auto geometry = arm->geometry();
    ASSERT_TRUE(geometry);
    EXPECT_EQ(geometry->pose, (Pose3d{1, 2, 3, 0.5, 0.25, 0.125}));
    const JointGeometry& joint = geometry->joints.at(0);
    EXPECT_TRUE(joint.rotary && joint.has_brakes);
    EXPECT_THAT(joint.axis, ElementsAre(0, 0, 1));
    EXPECT_THAT(joint.orientation, ElementsAre(0.1, 0.2, 0.3));
    EXPECT_THAT((std::vector{joint.lowest, joint.centre, joint.highest, joint.home, joint.speed}),
                ElementsAre(-1, 0, 1, 0.25, 2));
  }
}

TEST(Equipment, AnArmIsToldWhereToMoveAndHowFast) {
  namespace act = wire::actarray;
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  FakeServer server(telling<act::Data>(act::kCode, {}));
  {
    Client client = connect(server);
    Result<ActArray> arm = ActArray::open(client, 0);
    ASSERT_TRUE(arm);
    EXPECT_TRUE(arm->move_to(1, 0.5) && arm->move_all_to(std::vector{0.5, 1.5}));
    EXPECT_TRUE(arm->move_at(1, -0.5) && arm->move_all_at(std::vector{0.25}));
    EXPECT_TRUE(arm->home() && arm->home(2));
    EXPECT_TRUE(arm->set_speed(ActArray::kAll, 0.125) && arm->set_motor_power(false) &&
                arm->set_brakes(true));
    EXPECT_EQ(arm->move_to(0, nan).error().text, "actarray:0: move_to takes finite numbers, not nan");
    EXPECT_FALSE(arm->move_all_to(std::vector{0.5, inf}) || arm->move_all_at(std::vector{1e39}));
    EXPECT_FALSE(arm->move_at(0, inf) || arm->set_speed(0, nan));
  }
  server.finish();
  const auto commands = [&]<typename T>(T, std::uint8_t subtype) {
    return sent<T>(server, act::kCode, MessageType::kCmd, subtype);
  };
  EXPECT_THAT(commands(act::PositionCmd(), act::kCmdPos), ElementsAre(act::PositionCmd{1, 0.5f}));
  EXPECT_THAT(commands(act::MultiPositionCmd(), act::kCmdMultiPos),
              ElementsAre(act::MultiPositionCmd{{0.5f, 1.5f}}));
  EXPECT_THAT(commands(act::SpeedCmd(), act::kCmdSpeed), ElementsAre(act::SpeedCmd{1, -0.5f}));
  EXPECT_THAT(commands(act::MultiSpeedCmd(), act::kCmdMultiSpeed), ElementsAre(act::MultiSpeedCmd{{0.25f}}));
  EXPECT_THAT(commands(act::HomeCmd(), act::kCmdHome), ElementsAre(act::HomeCmd{-1}, act::HomeCmd{2}));
  EXPECT_THAT(sent<act::SpeedConfig>(server, act::kCode, MessageType::kReq, act::kReqSpeed),
              ElementsAre(act::SpeedConfig{-1, 0.125f}));
  EXPECT_THAT(sent<act::PowerConfig>(server, act::kCode, MessageType::kReq, act::kReqPower),
              ElementsAre(act::PowerConfig{0}));
  EXPECT_THAT(sent<act::BrakesConfig>(server, act::kCode, MessageType::kReq, act::kReqBrakes),
              ElementsAre(act::BrakesConfig{1}));
}

TEST(Equipment, ALampIsSwitchedColoredAndMadeToFlash) {
  namespace bl = wire::blinkenlight;
  FakeServer server(telling<bl::Data>(bl::kCode, {{1, 1.5f, 0.5f, {0, 1, 2, 3}}}));
  {
    Client client = connect(server);
    Result<BlinkenLight> lamp = BlinkenLight::open(client, 0);
    ASSERT_TRUE(lamp);
    EXPECT_FALSE(lamp->state());
    ASSERT_TRUE(client.read());
    EXPECT_TRUE(lamp->state()->on);
    EXPECT_EQ(lamp->state()->period, 1.5);
    EXPECT_EQ(lamp->state()->duty_cycle, 0.5);
    EXPECT_THAT(lamp->state()->color, ElementsAre(1, 2, 3));
    EXPECT_TRUE(lamp->set_power(false) && lamp->set_color({4, 5, 6}, 3) && lamp->flash(2));
    EXPECT_TRUE(lamp->set(true, 1, 0.25, {7, 8, 9}));
    EXPECT_EQ(lamp->flash(std::nan("")).error().text, "blinkenlight:0: flash takes finite numbers, not nan");
    EXPECT_FALSE(lamp->set(true, 0, 1e39, {}));
  }
  server.finish();
  EXPECT_THAT(sent<bl::CmdPower>(server, bl::kCode, MessageType::kCmd, bl::kCmdPower),
              ElementsAre(bl::CmdPower{0, 0}));
  EXPECT_THAT(sent<bl::CmdColor>(server, bl::kCode, MessageType::kCmd, bl::kCmdColor),
              ElementsAre(bl::CmdColor{3, {255, 4, 5, 6}}));
  EXPECT_THAT(sent<bl::CmdFlash>(server, bl::kCode, MessageType::kCmd, bl::kCmdFlash),
              ElementsAre(bl::CmdFlash{0, 2, 0.5f}));
  EXPECT_THAT(sent<bl::Cmd>(server, bl::kCode, MessageType::kCmd, bl::kCmdState),
              ElementsAre(bl::Cmd{0, 1, 1, 0.25f, {255, 7, 8, 9}}));
}

TEST(Equipment, ABlobHasAColorOfThreeBytes) {
  namespace bf = wire::blobfinder;
  FakeServer server(telling<bf::Data>(bf::kCode, {{160, 120, {{4, 0x123456, 12, 1, 2, 3, 4, 5, 6, 0.5f}}}}));
  Client client = connect(server);
  Result<Blobfinder> eye = Blobfinder::open(client, 0);
  ASSERT_TRUE(eye);
  EXPECT_THAT(eye->blobs(), IsEmpty());
  EXPECT_FALSE(eye->image_size());
  ASSERT_TRUE(client.read());
  EXPECT_EQ(*eye->image_size(), (ImageSize{160, 120}));
  const std::vector<Blob> blobs = eye->blobs();
  ASSERT_EQ(blobs.size(), 1u);
  const auto& [channel, color, area, x, y, left, right, top, bottom, range] = blobs[0];
  EXPECT_THAT(color, ElementsAre(0x12, 0x34, 0x56));
  EXPECT_THAT((std::vector{channel, area, x, y, left, right, top, bottom}),
              ElementsAre(4, 12, 1, 2, 3, 4, 5, 6));
  EXPECT_EQ(range, 0.5);
}

TEST(Equipment, LevelsOfARadioAreSignedInDbm) {
  namespace wf = wire::wifi;
  const wf::Link link{{'a', ':', 'b', 0, 'x'}, {'1', '.', '2'}, {}, wf::kModeInfra, 2412, 1, 40, -48, -100};
  wf::Data data{{link}, 1, 2, wf::kModeInfra, wf::kQualDbm, 70, -48, -100, "cc"};
  wf::Data relative = data;
  relative.qual_type = wf::kQualRel;
  FakeServer server(
      telling<wf::Data>(wf::kCode, {data, relative}, wire::encode(wf::MacReq{{'c', ':', 'd'}})));
  Client client = connect(server);
  Result<Wifi> radio = Wifi::open(client, 0);
  ASSERT_TRUE(radio);
  EXPECT_FALSE(radio->state());
  EXPECT_THAT(radio->links(), IsEmpty());
  EXPECT_EQ(*radio->mac(), "c:d");
  ASSERT_TRUE(client.read());
  const std::vector<Link> links = radio->links();
  ASSERT_EQ(links.size(), 1u);
  EXPECT_EQ(links[0].mac + links[0].ip + links[0].essid, "a:b1.2");
  EXPECT_TRUE(links[0].encrypted);
  EXPECT_THAT((std::vector{links[0].level, links[0].noise}), ElementsAre(-48, -100));
  const auto state = radio->state();
  EXPECT_THAT((std::vector{state->max_level, state->max_noise}), ElementsAre(-48, -100));
  EXPECT_THAT((std::vector{state->throughput, state->bitrate, state->mode, state->unit, state->max_quality}),
              ElementsAre(1, 2, wf::kModeInfra, wf::kQualDbm, 70));
  EXPECT_EQ(state->access_point, "cc");
  ASSERT_TRUE(client.read());
  EXPECT_EQ(radio->links()[0].level, (std::int64_t{1} << 32) - 48);
}

TEST(Equipment, HasNoDataOfARunThatWasRestarted) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    tell(peer, wire::gripper::kCode, wire::gripper::Data{});
    tell(peer, wire::power::kCode, wire::power::Data{});
    tell(peer, wire::actarray::kCode, wire::actarray::Data{{{}}, 1});
    tell(peer, wire::blinkenlight::kCode, wire::blinkenlight::Data{});
    tell(peer, wire::blobfinder::kCode, wire::blobfinder::Data{});
    tell(peer, wire::wifi::kCode, wire::wifi::Data{});
    peer.answer(message, message.body);
  }));
  Client client = connect(server, {.mode = Mode::kPush});
  const auto hand = Gripper::open(client, 0);
  const auto battery = Power::open(client, 0);
  const auto arm = ActArray::open(client, 0);
  const auto lamp = BlinkenLight::open(client, 0);
  const auto eye = Blobfinder::open(client, 0);
  const auto radio = Wifi::open(client, 0);
  auto world = Simulation::open(client, 0);
  ASSERT_TRUE(hand && battery && arm && lamp && eye && radio && world && world->step());
  EXPECT_TRUE(hand->state() && battery->state() && arm->state() && lamp->state() && eye->image_size() &&
              radio->state());
  ASSERT_TRUE(world->reset(7));
  EXPECT_FALSE(hand->state() || battery->state() || arm->state() || lamp->state() || eye->image_size() ||
               radio->state());
}

}  // namespace
}  // namespace playhouse::client
