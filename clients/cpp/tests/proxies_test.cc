#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "fake_server.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse_client/client.h"
#include "playhouse_client/robot.h"
#include "playhouse_client/simulation.h"
#include "testing_scripts.h"

namespace playhouse::client {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using wire::MessageType;

TEST(Reading, ABumperHasWhichSwitchesArePressedAndWhereTheyAre) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    const wire::bumper::Geom geom{{{{0.25, 0, 0.1, 0, 0, 0.5}, 0.5f, 0}}};
    peer.answer(message, wire::encode(geom));
    wire::Header header;
    header.interf = wire::bumper::kCode;
    header.subtype = wire::bumper::kDataState;
    peer.say(header, wire::encode(wire::bumper::Data{{0, 1, 255}}));
    peer.synch();
  }));
  Client client = connect(server);
  Result<Bumper> skirt = Bumper::open(client, 0);
  ASSERT_TRUE(skirt);
  EXPECT_THAT(skirt->pressed(), IsEmpty());
  EXPECT_EQ(*client.read(), 1u);
  EXPECT_THAT(skirt->pressed(), ElementsAre(false, true, true));
  const auto faces = skirt->faces();
  ASSERT_TRUE(faces);
  ASSERT_EQ(faces->size(), 1u);
  EXPECT_EQ((*faces)[0].pose.x, 0.25);
  EXPECT_EQ((*faces)[0].pose.yaw, 0.5);
  EXPECT_EQ((*faces)[0].length, 0.5);
}

/// Data of a device with index 0, subtype 1, measured at 2.5 s.
template <typename T>
void say_data(Peer& peer, std::uint16_t interf, const T& value) {
  wire::Header header;
  header.interf = interf;
  header.subtype = 1;
  header.timestamp = 2.5;
  peer.say(header, wire::encode(value));
}

TEST(Reading, AnalogInputsAreVoltagesAndOutputsAreSetOneByOne) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    if (message.header.type == MessageType::kCmd) return;
    peer.answer(message);
    say_data(peer, wire::aio::kCode, wire::aio::Data{{0.5f, -3.0f}});
    peer.synch();
  }));
  {
    Client client = connect(server);
    Result<Aio> box = Aio::open(client, 0);
    ASSERT_TRUE(box);
    EXPECT_THAT(box->voltages(), IsEmpty());
    ASSERT_TRUE(client.read());
    EXPECT_THAT(box->voltages(), ElementsAre(0.5, -3.0));
    EXPECT_EQ(box->set(1, std::nan("")).error().text, "aio:0: set takes finite numbers, not nan");
    EXPECT_EQ(box->set(1, 1e39).error().text, "aio:0: set takes finite numbers, not one beyond float");
    EXPECT_TRUE(box->set(2, 1.5));
  }
  server.finish();
  std::vector<wire::aio::Cmd> commands;
  for (const Received& message : server.received())
    if (message.header.type == MessageType::kCmd)
      commands.push_back(*wire::decode<wire::aio::Cmd>(message.body));
  EXPECT_THAT(commands, ElementsAre(wire::aio::Cmd{2, 1.5f}));
}

TEST(Reading, ACameraTellsItsPixels) {
  namespace camera = wire::camera;
  std::vector<camera::Data> pictures = {
      {2, 1, 24, camera::kFormatRgb888, 1, camera::kCompressRaw, {1, 2, 3, 4, 5, 6}},
      {1, 2, 16, camera::kFormatMono16, 1, camera::kCompressRaw, {0x34, 0x12, 0, 0}},
      {2, 1, 24, camera::kFormatRgb888, 1, camera::kCompressJpeg, {0xFF, 0xD8}},
      {2, 1, 24, camera::kFormatRgb888, 1, camera::kCompressRaw, {1, 2, 3, 4, 5}},
      {0xFFFFFFFF, 0xFFFFFFFF, 24, camera::kFormatRgb888, 1, camera::kCompressRaw, {}},
  };
  std::size_t next = 0;
  FakeServer server(rounds([&](Peer& peer, const Received& message) {
    peer.answer(message);
    say_data(peer, camera::kCode, pictures.at(next++));
    peer.synch();
  }));
  Client client = connect(server);
  Result<Camera> eye = Camera::open(client, 0);
  ASSERT_TRUE(eye);
  EXPECT_FALSE(eye->image());
  ASSERT_TRUE(client.read());
  EXPECT_EQ(eye->image()->time, 2.5);
  EXPECT_THAT(*eye->image()->pixel(0, 0), ElementsAre(1, 2, 3));
  EXPECT_THAT(*eye->image()->pixel(1, 0), ElementsAre(4, 5, 6));
  EXPECT_EQ(eye->image()->pixel(2, 0).error().text, "pixel 2, 0 is outside the 2 x 1 picture");
  ASSERT_TRUE(client.read());
  EXPECT_THAT(*eye->image()->pixel(0, 0), ElementsAre(0x1234));
  EXPECT_THAT(*eye->image()->pixel(0, 1), ElementsAre(0));
  ASSERT_TRUE(client.read());
  EXPECT_TRUE(eye->image()->is_jpeg);
  EXPECT_THAT(eye->image()->pixel(0, 0).error().text, HasSubstr("raw MONO8, MONO16 and RGB888 alone"));
  ASSERT_TRUE(client.read());
  EXPECT_TRUE(eye->image()->pixel(0, 0));
  EXPECT_THAT(eye->image()->pixel(1, 0).error().text, HasSubstr("fewer bytes than pixels: 5"));
  ASSERT_TRUE(client.read());
  EXPECT_THAT(eye->image()->pixel(0xFFFFFFFE, 0xFFFFFFFE).error().text, HasSubstr("fewer bytes"));
}

TEST(Reading, AMountSaysWhereItLooksAndIsToldWhereTo) {
  namespace ptz = wire::ptz;
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    if (message.header.type == MessageType::kCmd) return;
    const ptz::Geom geom{{0.25, 0, 0.5, 0, 0, 0}, {0.1, 0.2, 0.3}};
    peer.answer(message, message.header.interf == ptz::kCode && message.header.subtype == ptz::kReqGeom
                             ? wire::encode(geom)
                             : std::vector<std::byte>());
    if (message.header.interf == ptz::kCode) return;
    say_data(peer, ptz::kCode, ptz::Data{0.5f, -0.25f, 1, 0.125f, 2, 0});
    peer.synch();
  }));
  {
    Client client = connect(server);
    Result<Ptz> mount = Ptz::open(client, 0);
    ASSERT_TRUE(mount);
    EXPECT_FALSE(mount->view());
    ASSERT_TRUE(client.read());
    EXPECT_EQ(*mount->view(), (View{0.5, -0.25, 1, 0.125, 2}));
    EXPECT_TRUE(mount->look(1, 0.5));
    EXPECT_TRUE(mount->set_velocity_control(true));
    EXPECT_TRUE(mount->turn(-0.5));
    EXPECT_EQ(mount->look(std::nan("")).error().text, "ptz:0: look takes finite numbers, not nan");
    EXPECT_FALSE(mount->turn(0, std::numeric_limits<double>::infinity()));
    const auto geometry = mount->geometry();
    ASSERT_TRUE(geometry);
    EXPECT_EQ(geometry->pose, (Pose3d{0.25, 0, 0.5, 0, 0, 0}));
    EXPECT_EQ(geometry->size, (Size{0.2, 0.1, 0.3}));
  }
  server.finish();
  std::vector<ptz::Cmd> commands;
  std::vector<std::uint32_t> modes;
  for (const Received& message : server.received()) {
    if (message.header.interf != ptz::kCode) continue;
    if (message.header.type == MessageType::kCmd) commands.push_back(*wire::decode<ptz::Cmd>(message.body));
    if (message.header.type == MessageType::kReq && message.header.subtype == ptz::kReqControlMode)
      modes.push_back(wire::decode<ptz::ReqControlMode>(message.body)->mode);
  }
  EXPECT_THAT(commands, ElementsAre(ptz::Cmd{1, 0.5f, 0, 0, 0}, ptz::Cmd{0, 0, 0, -0.5f, 0}));
  EXPECT_THAT(modes, ElementsAre(ptz::kVelocityControl));
}

TEST(Reading, ALocalizationTellsWhereTheRobotMayBeAndIsTold) {
  namespace localize = wire::localize;
  const std::array<double, 6> spread = {0.25, 0.5, 0.125, 0.1, 0.2, 0.3};
  std::vector<localize::Data> told = {{0, 1, {{{1, 2, 0.5}, spread, 0.75}, {{}, {}, 0.25}}}, {}};
  std::size_t next = 0;
  FakeServer server(rounds([&](Peer& peer, const Received& message) {
    if (message.header.interf == wire::player::kCode) {
      peer.answer(message);
      say_data(peer, localize::kCode, told.at(next++));
      return peer.synch();
    }
    if (message.header.subtype == localize::kReqGetParticles)
      return peer.answer(message, wire::encode(localize::GetParticles{{}, 0, {{{3, 4, 1}, 0.5}}}));
    const bool refused = wire::decode<localize::SetPose>(message.body)->cov[0] < 0;
    peer.answer(message, {}, refused ? MessageType::kNack : MessageType::kAck);
  }));
  {
    Client client = connect(server);
    Result<Localize> place = Localize::open(client, 0);
    ASSERT_TRUE(place);
    EXPECT_THAT(place->hypotheses(), IsEmpty());
    EXPECT_FALSE(place->pose());
    ASSERT_TRUE(client.read());
    EXPECT_THAT(place->hypotheses(),
                ElementsAre(Hypothesis{{1, 2, 0.5}, {0.25, 0.5, 0.125, 0.1, 0.2, 0.3}, 0.75},
                            Hypothesis{{}, {}, 0.25}));
    EXPECT_EQ(place->pose(), (Pose{1, 2, 0.5}));
    ASSERT_TRUE(client.read());
    EXPECT_FALSE(place->pose()) << "there is no hypothesis";
    EXPECT_TRUE(place->set_pose({1, 2, 0.5}, Covariance::of_deviations(0.5, 2, 3)));
    EXPECT_THAT(place->set_pose({1, 2, 0.5}, {.xx = -1}).error().line(), HasSubstr("refused"));
    EXPECT_EQ(place->set_pose({1, std::nan(""), 0.5}, {}).error().text,
              "localize:0: set_pose takes finite numbers, not nan");
    EXPECT_FALSE(place->set_pose({1, 2, 0.5}, {.xa = std::numeric_limits<double>::infinity()}));
    const auto particles = place->particles();
    ASSERT_TRUE(particles);
    EXPECT_THAT(*particles, ElementsAre(Particle{{3, 4, 1}, 0.5}));
  }
  server.finish();
  std::vector<localize::SetPose> sent;
  for (const Received& message : server.received())
    if (message.header.interf == localize::kCode && message.header.subtype == localize::kReqSetPose)
      sent.push_back(*wire::decode<localize::SetPose>(message.body));
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_EQ(sent[0], (localize::SetPose{{1, 2, 0.5}, {0.25, 4, 9, 0, 0, 0}}));
}

TEST(Reading, APlannerGoesToAGoalAndTellsWhenTheRobotIsThere) {
  namespace planner = wire::planner;
  const wire::Pose2d goal{6, 4, 1.5}, way{2, 1, 0};
  std::vector<planner::Data> told = {
      {1, 1, {}, {}, {}, -1, 2},  // of a goal before
      {1, 0, {0.5, 0, 0}, goal, way, 1, 3},
      {1, 1, goal, goal, {}, -1, 3},
  };
  std::size_t next = 0;
  FakeServer server(rounds([&](Peer& peer, const Received& message) {
    if (message.header.type == MessageType::kCmd) return;
    if (message.header.interf == planner::kCode)
      return peer.answer(message, message.header.subtype == planner::kReqGetWaypoints
                                      ? wire::encode(planner::WaypointsReq{7.5, {way, goal}})
                                      : std::vector<std::byte>());
    peer.answer(message);
    say_data(peer, planner::kCode, told.at(next++));
    peer.synch();
  }));
  {
    Client client = connect(server);
    Result<Planner> guide = Planner::open(client, 0);
    ASSERT_TRUE(guide);
    EXPECT_FALSE(guide->state());
    EXPECT_FALSE(guide->arrived());
    EXPECT_TRUE(guide->go_to({6, 4, 1.5 + 4 * std::numbers::pi}));
    ASSERT_TRUE(client.read());
    EXPECT_FALSE(guide->arrived()) << "at a goal before";
    ASSERT_TRUE(client.read());
    const auto state = guide->state();
    EXPECT_TRUE(state->valid && !state->done && !guide->arrived());
    EXPECT_EQ(state->pose, (Pose{0.5, 0, 0}));
    EXPECT_EQ(state->goal, (Pose{6, 4, 1.5}));
    EXPECT_EQ(state->waypoint, (Pose{2, 1, 0}));
    EXPECT_EQ(state->index, 1);
    EXPECT_EQ(state->count, 3u);
    EXPECT_EQ(state->time, 2.5);
    ASSERT_TRUE(client.read());
    EXPECT_TRUE(guide->arrived());
    EXPECT_TRUE(guide->stop());
    EXPECT_TRUE(guide->resume());
    const auto path = guide->path();
    ASSERT_TRUE(path);
    EXPECT_THAT(path->waypoints, ElementsAre(Pose{2, 1, 0}, Pose{6, 4, 1.5}));
    EXPECT_EQ(path->length, 7.5);
    EXPECT_TRUE(guide->go_to({6, 4, 0}));
    EXPECT_FALSE(guide->arrived()) << "another heading";
    EXPECT_EQ(guide->go_to({0, std::numeric_limits<double>::infinity(), 0}).error().text,
              "planner:0: go_to takes finite numbers, not infinity");
  }
  server.finish();
  std::vector<int> goals, enabled;
  for (const Received& message : server.received()) {
    if (message.header.interf != planner::kCode) continue;
    if (message.header.type == MessageType::kCmd) goals.push_back(message.header.subtype);
    if (message.header.type == MessageType::kReq && message.header.subtype == planner::kReqEnable)
      enabled.push_back(wire::decode<planner::EnableReq>(message.body)->state);
  }
  EXPECT_THAT(goals, ElementsAre(planner::kCmdGoal, planner::kCmdGoal));
  EXPECT_THAT(enabled, ElementsAre(0, 1));
}

TEST(Reading, APlannerIsFollowedToItsGoalUnlessItRefusesIt) {
  namespace planner = wire::planner;
  const wire::Pose2d goal{6, 4, 1.5}, off{99, 0, 0}, own{2, 3, 0};
  const std::vector<planner::Data> told = {
      {0, 0, {}, goal, {}, -1, 0},  // a server without reasons
      {1, 0, {}, goal, goal, 0, 1}, {1, 1, goal, goal, {}, -1, 1},
      {0, 0, {}, off, {}, -1, 0},  // has not planned yet
      {0, 0, {}, off, {}, -1, 0},
      {1, 0, {}, own, own, 0, 1},
      {1, 0, {}, goal, goal, 0, 1},  // of another client
      {1, 0, {}, goal, goal, 0, 1}, {1, 0, {}, goal, goal, 0, 1},
  };
  std::deque<std::optional<std::string>> reasons = {std::nullopt, std::nullopt, "", "no path", "", "", ""};
  std::size_t next = 0;
  FakeServer server(rounds([&](Peer& peer, const Received& message) {
    if (message.header.type == MessageType::kCmd) return;
    if (message.header.interf == planner::kCode) {
      const auto asked = wire::decode<wire::StrpropReq>(message.body);
      EXPECT_EQ(wire::text(asked->key), "refusal");
      const std::optional<std::string> why = reasons.front();
      reasons.pop_front();
      if (!why) return peer.answer(message, {}, MessageType::kNack);
      return peer.answer(message, wire::encode(wire::StrpropReq{asked->key, wire::c_string(*why)}));
    }
    peer.answer(message);
    say_data(peer, planner::kCode, told.at(next++));
    peer.synch();
  }));
  {
    Client client = connect(server);
    Result<Planner> guide = Planner::open(client, 0);
    ASSERT_TRUE(guide);
    EXPECT_TRUE(guide->drive_to(client, {6, 4, 1.5}));
    EXPECT_EQ(*guide->why_refused(), "");
    const Result<void> refused = guide->drive_to(client, {99, 0, 0});
    EXPECT_EQ(refused.error().line(), "planner:0: no path");
    EXPECT_EQ(guide->drive_to(client, {2, 3, 0}).error().line(),
              "planner:0: it has another goal, or no longer one");
  }
  server.finish();
  EXPECT_EQ(next, told.size());
  EXPECT_TRUE(reasons.empty());
}

std::vector<std::int8_t> compressed(const std::vector<std::int8_t>& values) {
  uLongf size = compressBound(values.size());
  std::vector<std::int8_t> stream(size);
  PLAYHOUSE_ASSERT(compress(reinterpret_cast<Bytef*>(stream.data()), &size,
                            reinterpret_cast<const Bytef*>(values.data()), values.size()) == Z_OK);
  stream.resize(size);
  return stream;
}

TEST(Reading, AMapComesWholeInTiles) {
  namespace map = wire::map;
  constexpr std::uint32_t kWidth = 600, kHeight = 514;
  const auto value = [](std::uint32_t column, std::uint32_t row) {
    return static_cast<std::int8_t>(static_cast<int>((column + 3 * row) % 201) - 100);
  };
  FakeServer server(rounds([&](Peer& peer, const Received& message) {
    if (message.header.interf == wire::player::kCode) return;
    if (message.header.subtype == map::kReqGetInfo)
      return peer.answer(message, wire::encode(map::Info{0.5f, kWidth, kHeight, {-1, 2, 0}}));
    map::Data tile = *wire::decode<map::Data>(message.body);
    for (std::uint32_t i = 0; i < tile.width * tile.height; ++i)
      tile.data.push_back(value(tile.col + i % tile.width, tile.row + i / tile.width));
    tile.data_range = 100;
    if (tile.row == 0) tile.data = compressed(tile.data);  // and others as a server without zlib
    peer.answer(message, wire::encode(tile));
  }));
  {
    Client client = connect(server, {.mode = Mode::kPush});
    Result<Map> plan = Map::open(client, 0);
    ASSERT_TRUE(plan);
    const auto grid = plan->grid();
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->cell_size, 0.5);
    EXPECT_EQ(grid->width, kWidth);
    EXPECT_EQ(grid->height, kHeight);
    EXPECT_EQ(grid->origin, (Pose{-1, 2, 0}));
    const auto cells = plan->cells();
    ASSERT_TRUE(cells) << cells.error().line();
    ASSERT_EQ(cells->size(), kHeight);
    for (std::uint32_t row = 0; row < kHeight; ++row) {
      ASSERT_EQ((*cells)[row].size(), kWidth);
      for (std::uint32_t column = 0; column < kWidth; ++column)
        ASSERT_EQ((*cells)[row][column], (value(column, row) > 50) - (value(column, row) < -50));
    }
  }
  server.finish();
  std::vector<std::array<std::uint32_t, 4>> tiles;
  for (const Received& message : server.received()) {
    if (message.header.interf != map::kCode || message.header.subtype != map::kReqGetData) continue;
    const auto tile = *wire::decode<map::Data>(message.body);
    tiles.push_back({tile.col, tile.row, tile.width, tile.height});
  }
  EXPECT_THAT(tiles, ElementsAre(ElementsAre(0, 0, 512, 512), ElementsAre(512, 0, 88, 512),
                                 ElementsAre(0, 512, 512, 2), ElementsAre(512, 512, 88, 2)));
}

TEST(Reading, APointOfTheWorldIsInACellOrBeyondTheMap) {
  const Grid grid{0.5, 4, 2, {10, 20, std::numbers::pi / 2}};  // columns go along y, rows against x
  EXPECT_EQ(grid.cell_of({9.9, 20.1}), (Cell{0, 0}));
  EXPECT_EQ(grid.cell_of({9.4, 21.9}), (Cell{3, 1}));
  for (const Point& point : {Point{10.1, 20.1}, Point{9.9, 19.9}, Point{9.9, 22.1}, Point{8.9, 20.1},
                             Point{std::nan(""), 20.1}, Point{9.9, std::numeric_limits<double>::infinity()}})
    EXPECT_FALSE(grid.cell_of(point)) << point.x << " " << point.y;
}

TEST(Reading, MapsThatMakeNoSenseAreAnError) {
  namespace map = wire::map;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<map::Info> infos = {
      {0, 2, 2, {}},    {kNan, 2, 2, {}}, {0.5f, 2, 2, {kInfinity, 0, 0}}, {0.5f, 1 << 14, (1 << 12) + 1, {}},
      {0.5f, 2, 2, {}}, {0.5f, 2, 2, {}}, {0.5f, 0, 1u << 31, {}}};
  const std::vector<std::vector<std::int8_t>> tiles = {compressed({1, 1, 1}),
                                                       compressed(std::vector<std::int8_t>(1 << 20))};
  std::size_t info = 0, tile = 0;
  FakeServer server(rounds([&](Peer& peer, const Received& message) {
    if (message.header.interf == wire::player::kCode) return;
    peer.answer(message, message.header.subtype == map::kReqGetInfo
                             ? wire::encode(infos.at(info++))
                             : wire::encode(map::Data{0, 0, 2, 2, 1, tiles.at(tile++)}));
  }));
  Client client = connect(server, {.mode = Mode::kPush});
  Result<Map> plan = Map::open(client, 0);
  ASSERT_TRUE(plan);
  for (const char* fault : {"are those of no map", "are those of no map", "are those of no map",
                            "16384 x 4097 cells are over the limit", "a tile of 2 x 2 cells is damaged",
                            "a tile of 2 x 2 cells is damaged"})
    EXPECT_THAT(plan->cells().error().text, HasSubstr(fault));
  const auto cells = plan->cells();
  ASSERT_TRUE(cells);
  EXPECT_THAT(*cells, IsEmpty());
}

wire::opaque::Data bytes_of(std::string_view text) {
  return {{text.begin(), text.end()}};
}

TEST(Radio, MessagesThatArriveAreKeptInTheirOrderUntilTheyAreTaken) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.answer(message);
    say_data(peer, wire::opaque::kCode, bytes_of("first"));
    say_data(peer, wire::opaque::kCode, bytes_of(std::string_view("\0second", 7)));
    say_data(peer, wire::opaque::kCode, bytes_of(""));
    peer.synch();
  }));
  Client client = connect(server);
  Result<Opaque> opened = Opaque::open(client, 0);
  ASSERT_TRUE(opened);
  Opaque radio = std::move(*opened);
  int called = 0;
  radio.device().on_data([&](std::uint8_t, std::span<const std::byte>, double) { ++called; });
  EXPECT_THAT(radio.take_messages(), IsEmpty());
  EXPECT_EQ(*client.read(), 3u);
  EXPECT_THAT(radio.take_messages(), ElementsAre("first", std::string("\0second", 7), ""));
  EXPECT_THAT(radio.take_messages(), IsEmpty());
  EXPECT_EQ(called, 3) << "a callback of the program's own takes nothing away";
  ASSERT_TRUE(radio.device().close());
  EXPECT_THAT(radio.take_messages(), IsEmpty());
}

TEST(Radio, OfMoreMessagesThanAreKeptTheOldestAreLost) {
  int round = 0;
  FakeServer server(rounds([&](Peer& peer, const Received& message) {
    peer.answer(message);
    const int from = 300 * round++;
    for (int i = from; i < from + 300; ++i) say_data(peer, wire::opaque::kCode, bytes_of(std::to_string(i)));
    peer.synch();
  }));
  Client client = connect(server);
  Result<Opaque> radio = Opaque::open(client, 0);
  ASSERT_TRUE(radio);
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(client.read());
  const std::vector<std::string> taken = radio->take_messages();
  ASSERT_EQ(taken.size(), Opaque::kWaiting);
  EXPECT_EQ(taken.front(), std::to_string(1200 - Opaque::kWaiting));
  EXPECT_EQ(taken.back(), "1199");
}

TEST(Radio, SendsToAllByCommandAndToOneByRequest) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    if (message.header.type == MessageType::kCmd) return;
    const bool to_nobody = wire::decode<wire::opaque::Data>(message.body)->data.front() == '9';
    peer.answer(message, {}, to_nobody ? MessageType::kNack : MessageType::kAck);
  }));
  {
    Client client = connect(server);
    Result<Opaque> radio = Opaque::open(client, 0);
    ASSERT_TRUE(radio);
    EXPECT_TRUE(radio->send("to all"));
    EXPECT_TRUE(radio->send_to("10.0.0.1", "to one"));
    EXPECT_THAT(radio->send_to("9.9.9.9", "to nobody").error().line(), HasSubstr("refused"));
    const std::string endless(limits::kMessageBytes, 'x');
    EXPECT_THAT(radio->send(endless).error().text, HasSubstr("over the wire's limit"));
    EXPECT_THAT(radio->send_to("", endless).error().text, HasSubstr("over the wire's limit"));
  }
  server.finish();
  std::vector<std::string> sent;
  for (const Received& message : server.received()) {
    if (message.header.interf != wire::opaque::kCode) continue;
    const auto data = wire::decode<wire::opaque::Data>(message.body)->data;
    sent.emplace_back(data.begin(), data.end());
  }
  EXPECT_THAT(sent, ElementsAre("to all", std::string("10.0.0.1\0to one", 15),
                                std::string("9.9.9.9\0to nobody", 17)));
}

TEST(Resetting, DropsWhatCameBeforeTheAnswerAndKeepsWhatComesAfter) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.position(2, 2.0);
    say_data(peer, wire::opaque::kCode, bytes_of("old"));
    peer.answer(message, message.body);
    peer.position(3, 0.5);
  }));
  Client client = connect(server, {.mode = Mode::kPush});
  Position2d robot = open_robot(client);
  Result<Opaque> radio = Opaque::open(client, 0);
  Result<Simulation> world = Simulation::open(client, 0);
  ASSERT_TRUE(radio && world && world->step());
  ASSERT_TRUE(robot.state());
  ASSERT_TRUE(world->reset(7));
  EXPECT_FALSE(robot.state());
  EXPECT_FALSE(robot.device().take_fresh());
  EXPECT_EQ(robot.device().timestamp(), 0);
  EXPECT_THAT(radio->take_messages(), IsEmpty());
  ASSERT_TRUE(client.read());
  EXPECT_EQ(robot.state()->pose.x, 3);
}

TEST(Resetting, DropsNothingIfItIsRefused) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.position(2);
    peer.answer(message, {}, MessageType::kNack);
  }));
  Client client = connect(server, {.mode = Mode::kPush});
  Position2d robot = open_robot(client);
  Result<Simulation> world = Simulation::open(client, 0);
  ASSERT_TRUE(world);
  EXPECT_FALSE(world->reset(7));
  ASSERT_TRUE(client.read());
  EXPECT_EQ(robot.state()->pose.x, 2);
}

TEST(Resetting, ATimeThatGoesBackDropsWhatOtherDevicesHaveOfALaterOne) {
  FakeServer server(rounds([](Peer& peer, const Received& message) {
    peer.position(1, 1.0);
    say_data(peer, wire::aio::kCode, wire::aio::Data{{0.5f}});
    peer.position(2, 0.5);
    peer.answer(message, message.body);
  }));
  Client client = connect(server, {.mode = Mode::kPush});
  Position2d robot = open_robot(client);
  Result<Aio> box = Aio::open(client, 0);
  Result<Simulation> world = Simulation::open(client, 0);
  ASSERT_TRUE(box && world && world->step());
  EXPECT_EQ(robot.state()->pose.x, 2);
  EXPECT_THAT(box->voltages(), IsEmpty());
}

}  // namespace
}  // namespace playhouse::client
