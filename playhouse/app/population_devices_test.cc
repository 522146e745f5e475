// Robots that come and go by the thousand in front of clients: every client hears of what it had open,
// nothing is lost, and nothing is left. First without threads, over the simulated network; then a whole
// program's worth of threads over TCP. Out of scope here: which addresses robots get (bridge/simulated).

#include <gtest/gtest.h>

#include <deque>
#include <future>
#include <map>
#include <thread>

#include "playhouse/app/service.h"
#include "playhouse/bridge/simulated/auto_devices.h"
#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/device_server/server_host.h"
#include "playhouse/run/testing/still_engine.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/world/population/population.h"
#include "playhouse_client/laser.h"
#include "playhouse_client/position2d.h"

namespace playhouse {
namespace {

using server::Received;
using server::TestClient;
using world::ModelId;
namespace p2d = wire::position2d;

constexpr std::uint16_t kPort = 6665;
constexpr std::uint16_t kWheels = p2d::kCode, kLaser = wire::laser::kCode, kRanger = wire::ranger::kCode;
constexpr std::uint8_t kPull = 2;

// One robot from the start: a laser, sonars and a finder besides its wheels.
constexpr const char* kWorld = R"(
interval_sim 100
position( name "r" size [0.4 0.4 0.3]
  ranger( sensor( samples 5 fov 180 range [0 8] ) )
  ranger( sensor( pose [0 0 0 0] ) sensor( pose [0 0 0 90] ) )
  fiducial( ) )
)";
constexpr std::size_t kDevicesOfRobot = 9;

/// A world with its server. The test is both threads.
class Town final : public device_server::ServerHost {
 public:
  explicit Town(std::size_t indices = drivers::AutoMap::kIndices)
      : scene_(run::testing::scene_of(kWorld)), site_(*this, kPort), server_(simulated) {
    EXPECT_EQ(*server_.listen(kPort), kPort);
    EXPECT_TRUE(site_.open_world("some.world"));
    site_.data_flow().pass_to(server_);
    robots_ = std::make_unique<drivers::AutoDevices>(site_, kPort, indices);
    EXPECT_TRUE(robots_->add_all());
  }
  ~Town() override { simulation().discard(); }

  run::Simulation& simulation() { return *drivers::simulation_of(site_); }
  drivers::Directory& directory() { return drivers::model_devices_of(site_)->directory(); }
  void ask(std::function<void(world::Journal&)> change) {
    ASSERT_TRUE(simulation().requests().post(std::move(change)));
  }
  void tick() {
    simulation().extend(1);
    simulation().run();
  }
  server::ServerStatus status() const { return server_.status(); }

  /// How many of everything that knows devices there are.
  struct Sizes {
    std::size_t table = 0, rows = 0, site = 0, driver = 0, directory = 0, sources = 0;
    friend bool operator==(const Sizes&, const Sizes&) = default;
  };
  Sizes sizes() {
    return {status().devices,
            status().device_rows,
            site_.device_count(),
            robots_->driver().device_count(),
            drivers::model_devices_of(site_)->directory().size(),
            drivers::model_devices_of(site_)->sources().size()};
  }

  server::Server& the_server() override { return server_; }
  net::Network& the_network() override { return simulated; }
  Result<std::unique_ptr<drivers::SiteWorld>> open_world(const std::string&, drivers::Site& site) override {
    return drivers::simulated_world(
        site, std::make_unique<run::Simulation>(
                  std::make_unique<run::testing::StillEngine>(scene_),
                  run::Simulation::SimulationOptions{.speed = 0, .paused = false, .duration = 0}));
  }

  net::SimulatedNetwork simulated{11};

 private:
  scene::SceneDesc scene_;
  drivers::Site site_;
  std::unique_ptr<drivers::AutoDevices> robots_;
  server::Server server_;
};

/// A client that counts what it hears.
class Listener {
 public:
  Listener(Town& town, bool pull) : client_(town.simulated, kPort), pull_(pull) {
    if (pull) client_.ask(server::mode_request(kPull));
  }
  void open(std::uint16_t interf, std::uint16_t index) { client_.send(server::open_request(interf, index)); }
  void drive(std::uint16_t index) {
    client_.send(server::message(wire::MessageType::kCmd, kWheels, index, p2d::kCmdVel,
                                 wire::encode(p2d::CmdVel{{0.1, 0, 0}, 1})));
  }
  /// Waits for the tick.
  void switch_motors_on(std::uint16_t index) {
    client_.send(server::message(wire::MessageType::kReq, kWheels, index, p2d::kReqMotorPower,
                                 wire::encode(p2d::PowerConfig{1})));
    ++asked;
  }
  void hear() {
    if (pull_) client_.send(server::player_request(wire::player::kReqData));
    for (const Received& received : client_.read()) count(received);
  }

  std::size_t asked = 0, answered = 0, opened = 0, refused = 0, gone = 0;
  std::map<std::pair<std::uint16_t, std::uint32_t>, std::size_t> data;  // by interface and index

 private:
  void count(const Received& received) {
    using wire::MessageType;
    const wire::Header& header = received.header;
    const bool answers = header.type == MessageType::kAck || header.type == MessageType::kNack;
    if (header.type == MessageType::kData) ++data[{header.interf, header.index}];
    if (answers && header.interf == kWheels) ++answered;
    if (!answers || header.interf != wire::player::kCode || header.subtype != wire::player::kReqDev) return;
    const std::uint8_t access = server::access_of(received);
    ++(header.type == MessageType::kNack || access == wire::player::kErrorMode ? refused
       : access == 'e'                                                         ? gone
                                                                               : opened);
  }

  TestClient client_;
  bool pull_;
};

TEST(PopulationDevices, of_a_thousand_robots_that_come_and_go_are_lost_to_nobody_and_leave_nothing) {
  constexpr std::uint16_t kRobots = 1000;
  constexpr std::size_t kLiving = 3;
  Town town;
  Listener pushed(town, false), pulled(town, true);
  const auto both = [&](auto&& each) {
    each(pushed);
    each(pulled);
  };
  both([](Listener& client) { client.open(kWheels, 0); });
  town.simulated.run();
  town.tick();
  town.simulated.run();
  const Town::Sizes before = town.sizes();
  ASSERT_EQ(before.table, kDevicesOfRobot + 1);

  std::deque<ModelId> living;
  std::size_t ticks = 1;
  for (std::uint16_t robot = 1; robot <= kRobots + kLiving; ++robot) {
    if (robot <= kRobots) town.ask([&](world::Journal& journal) { living.push_back(*journal.spawn(0, {})); });
    town.tick();
    town.simulated.run();
    both([&](Listener& client) {
      for (const std::uint16_t interf : {kWheels, kLaser, kRanger}) {
        const auto index = static_cast<std::uint16_t>(interf == kRanger ? 2 * robot : robot);
        if (robot <= kRobots) client.open(interf, index);
      }
      client.drive(robot);
      client.switch_motors_on(robot);
    });
    town.simulated.run();
    town.tick();
    both([](Listener& client) { client.hear(); });
    ticks += 2;
    if (robot <= kLiving) continue;
    // One goes, while clients open it once more and ask it.
    town.ask([&](world::Journal& journal) {
      EXPECT_TRUE(journal.despawn(living.front()));
      living.pop_front();
    });
    const auto going = static_cast<std::uint16_t>(robot - kLiving);
    both([&](Listener& client) {
      client.switch_motors_on(going);
      client.open(kWheels, going);
    });
    if (robot % 2 == 0) town.simulated.run();  // before the tick, or after it beside the retirement
    town.tick();
    ++ticks;
    both([](Listener& client) { client.hear(); });
  }
  for (int i = 0; i < 3; ++i) {
    town.tick();
    ++ticks;
    both([](Listener& client) { client.hear(); });
  }

  EXPECT_EQ(town.sizes(), before);
  EXPECT_EQ(town.status().devices_retired, kRobots * kDevicesOfRobot);
  EXPECT_EQ(town.status().output_bytes, 0u);
  EXPECT_EQ(town.status().data_dropped, 0u);
  both([&](Listener& client) {
    EXPECT_EQ(client.gone, 3u * kRobots) << "once for each device";
    EXPECT_EQ(client.answered, client.asked);
    EXPECT_EQ(client.opened + client.refused, 1u + 3u * kRobots + kRobots);
    EXPECT_GE(client.opened, 1u + 3u * kRobots + kRobots / 2);
    EXPECT_EQ((client.data[{kWheels, 0}]), ticks) << "of the robot that stays";
    for (std::uint16_t robot = 1; robot <= kRobots; ++robot) {
      EXPECT_GE((client.data[{kWheels, robot}]), 2 * kLiving) << robot;
      EXPECT_EQ((client.data[{kWheels, robot}]), (client.data[{kLaser, robot}])) << robot;
    }
  });
}

TEST(PopulationDevices, with_the_number_of_another_say_nothing_to_who_had_that_open_and_hear_nothing_of_it) {
  constexpr std::size_t kIndices = 128;
  Town town(kIndices);
  Listener pushed(town, false), pulled(town, true);
  ModelId newest;
  const auto come = [&] {
    town.ask([&](world::Journal& journal) { newest = *journal.spawn(0, {}); });
    town.tick();
    town.simulated.run();
  };
  const auto go = [&] {
    town.ask([&](world::Journal& journal) { EXPECT_TRUE(journal.despawn(newest)); });
    town.tick();
    town.simulated.run();
  };
  come();
  for (Listener* client : {&pushed, &pulled}) client->open(kWheels, 1);
  town.simulated.run();
  town.tick();
  town.tick();
  for (Listener* client : {&pushed, &pulled}) client->hear();
  go();
  for (std::size_t robot = 2; robot < kIndices; ++robot) {
    come();
    go();
  }
  for (int tick = 0; tick < 600; ++tick) town.tick();
  come();
  ASSERT_EQ(town.directory().model_of({kPort, kWheels, 1}), newest);

  const std::size_t told = (pushed.data[{kWheels, 1}]), pulled_told = (pulled.data[{kWheels, 1}]);
  pulled.drive(1);
  pulled.switch_motors_on(1);
  town.simulated.run();
  for (int tick = 0; tick < 10; ++tick) town.tick();
  const world::World& world = town.simulation().world();
  EXPECT_EQ(world.positions.command[world.position(newest)], geom::Twist{}) << "it means the first";
  EXPECT_EQ(town.status().commands_dropped, 1u);
  for (Listener* client : {&pushed, &pulled}) {
    client->hear();
    town.simulated.run();
    client->hear();
    EXPECT_EQ(client->gone, 1u);
  }
  EXPECT_EQ((pushed.data[{kWheels, 1}]), told);
  EXPECT_LE((pulled.data[{kWheels, 1}]), pulled_told + 1) << "one may have waited when the first went";
  EXPECT_EQ(pulled.answered, pulled.asked);

  pulled.drive(1);
  town.simulated.run();
  town.tick();
  EXPECT_NE(world.positions.command[world.position(newest)], geom::Twist{}) << "now it means this one";
}

TEST(PopulationDevices, follow_over_tcp_with_every_thread_of_the_program) {
  constexpr std::uint16_t kRobots = 100;
  app::Service service({.port = 0, .web = std::nullopt}, {.speed = 0}, app::QuitTime::kIgnored);
  service.take_scene(run::testing::scene_of(kWorld));
  ASSERT_TRUE(service.open_ports());
  ASSERT_TRUE(service.make_devices());
  const std::size_t before = service.server().status().devices;
  const std::uint16_t port = service.player_ports().front();
  run::Simulation& simulation = service.simulation();

  std::size_t opened = 0, gone = 0;
  std::string fault;
  const auto follow_all = [&]() -> Result<void> {
    Result<client::Client> client = client::Client::connect("127.0.0.1", port);
    if (!client) return client.error();
    for (std::uint16_t robot = 1; robot <= kRobots; ++robot) {
      ModelId id;
      std::promise<void> followed;
      simulation.requests().post([&](world::Journal& journal) { id = *journal.spawn(0, {}); });
      simulation.requests().post([&](const world::Journal&) { followed.set_value(); });
      followed.get_future().get();
      Result<client::Laser> laser = client::Laser::open(*client, robot);
      Result<client::Position2d> wheels = client::Position2d::open(*client, robot);
      if (!laser) return laser.error();
      if (!wheels) return wheels.error();
      ++opened;
      while (!laser->scan() || !wheels->state()) {
        if (const auto driven = wheels->drive(0.1, 0); !driven) return driven.error();
        if (const auto read = client->read(); !read) return read.error();
      }
      simulation.requests().post([=](world::Journal& journal) { EXPECT_TRUE(journal.despawn(id)); });
      while (!laser->device().gone() || !wheels->device().gone()) {
        static_cast<void>(wheels->drive(0.1, 0));  // refused once it has heard
        if (const auto read = client->read(); !read) return read.error();
      }
      ++gone;
    }
    return {};
  };
  std::thread program([&] {
    if (const Result<void> done = follow_all(); !done) fault = done.error().line();
    service.stop();
  });
  service.run();
  program.join();
  EXPECT_EQ(fault, "");
  EXPECT_EQ(opened, kRobots);
  EXPECT_EQ(gone, kRobots);
  EXPECT_EQ(service.server().status().devices, before);
  // Data may be dropped: nobody reads as fast as a run without a clock writes. Notices and answers are not.
}

}  // namespace
}  // namespace playhouse
