// Robots that have no index left on the first port, over TCP with every thread of the program: a port of few
// indices, and clients that look at the world through another port than they drive. Out of scope here: which
// address a robot gets (bridge/simulated).

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/commands/options.h"
#include "playhouse/app/commands/robots_client.h"
#include "playhouse/app/device_service.h"
#include "playhouse/app/free_ports.h"
#include "playhouse/app/service.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/run/testing/still_engine.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse_client/position2d.h"
#include "playhouse_client/robot.h"
#include "playhouse_client/simulation.h"

namespace playhouse {
namespace {

using client::Client;
using client::Position2d;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::StrEq;
using ::testing::UnorderedElementsAre;

constexpr std::size_t kIndices = 2;  // of a port
constexpr std::size_t kRobots = 5;   // on three ports

/// Robot k starts at (0, 2 k) and looks along x. Further ones may be bugs, which have a laser.
scene::SceneDesc robots_in_a_row() {
  std::string text =
      "interval_sim 100\n"
      "define bug position( size [0.4 0.4 0.3] ranger( sensor( samples 3 fov 180 ) ) )\n"
      "robot_types [ \"bug\" ]\n";
  for (std::size_t k = 0; k < kRobots; ++k)
    text += fmt::format("position( name \"r{}\" pose [0 {} 0 0] size [0.4 0.4 0.3] )\n", k, 2 * k);
  return run::testing::scene_of(text);
}

class FollowingPorts : public ::testing::Test {
 protected:
  /// "", or why the run cannot start.
  std::string prepare(std::uint16_t port) {
    service = std::make_unique<app::Service>(app::Serving{.port = port, .web = std::nullopt},
                                             app::Running{.speed = 10}, app::QuitTime::kIgnored);
    service->use_indices(kIndices);
    service->take_scene(robots_in_a_row());
    for (const auto step :
         {&app::Service::open_ports, &app::Service::make_devices, &app::Service::open_following_ports})
      if (const Result<void> done = (*service.*step)(); !done) return done.error().line();
    return "";
  }
  /// Runs while the client does its work; "" or why it failed.
  std::string run_beside(const std::function<Result<void>()>& work) {
    std::string fault;
    std::thread program([&] {
      if (const Result<void> done = work(); !done) fault = done.error().line();
      service->stop();
    });
    service->run();
    program.join();
    return fault;
  }
  /// As many in a row are free.
  static std::uint16_t first_of_free_ports(std::size_t count) {
    net::IoLoop loop;
    return app::hold_free_ports(loop, "127.0.0.1", count).front()->port();
  }
  std::uint16_t port(std::size_t number) const {
    return static_cast<std::uint16_t>(service->player_ports().front() + number);
  }
  Result<Client> connect(std::size_t number) const { return Client::connect("127.0.0.1", port(number)); }

  std::unique_ptr<app::Service> service;
};

/// Drives until the odometry says 1 m.
Result<void> drive_a_metre(Client& client, std::uint16_t index) {
  Result<Position2d> wheels = Position2d::open(client, index);
  if (!wheels) return wheels.error();
  do {
    if (const auto driven = wheels->drive(0.5, 0); !driven) return driven.error();
    if (const auto read = client.read(); !read) return read.error();
  } while (!wheels->state() || wheels->state()->pose.x < 1);
  return wheels->drive(0, 0);
}

TEST_F(FollowingPorts, have_the_robots_behind_the_first_and_the_world_on_each) {
  ASSERT_EQ(prepare(0), "");
  ASSERT_EQ(service->player_ports(), (std::vector<std::uint16_t>{port(0), port(1), port(2)}));
  EXPECT_EQ(run_beside([&]() -> Result<void> {
              Result<Client> driver = connect(1), watcher = connect(2);
              if (!driver) return driver.error();
              if (!watcher) return watcher.error();
              Result<client::Simulation> world = client::Simulation::open(*watcher, 0);
              if (!world) return world.error();
              if (const auto driven = drive_a_metre(*driver, 0); !driven) return driven;
              for (std::size_t k = 0; k < kRobots; ++k) {
                const Result<client::Pose> pose = world->pose(fmt::format("r{}", k));
                if (!pose) return pose.error();
                EXPECT_EQ(pose->y, 2.0 * static_cast<double>(k)) << k;
                EXPECT_EQ(pose->x >= 1, k == 2) << "index 0 of the second port is robot 2, not " << k;
                EXPECT_EQ(pose->x == 0, k != 2) << k;
              }
              Result<std::vector<client::Robot>> robots = watcher->robots();
              if (!robots) return robots.error();
              EXPECT_EQ(robots->size(), 1u) << "of this port";
              EXPECT_EQ(robots->front().name(), "r4");
              const auto drives = [](std::uint16_t interf) { return interf == wire::position2d::kCode; };
              const Result<app::DeviceName> elsewhere = app::find_device(*watcher, {{}, "r3"}, drives);
              EXPECT_FALSE(elsewhere);
              if (!elsewhere)
                EXPECT_EQ(elsewhere.error().text,
                          fmt::format("model \"r3\" has position2d:1 on port {} of this server", port(1)));
              return {};
            }),
            "");
}

TEST_F(FollowingPorts, are_opened_during_the_run_for_robots_that_come) {
  ASSERT_EQ(prepare(first_of_free_ports(4)), "");
  EXPECT_EQ(run_beside([&]() -> Result<void> {
              Result<Client> first = connect(0);
              if (!first) return first.error();
              Result<client::Simulation> world = client::Simulation::open(*first, 0);
              if (!world) return world.error();
              for (const char* name : {"five", "six"})
                if (const auto came = world->spawn("r0", {0, name[0] == 'f' ? 20.0 : 22.0, 0}, name); !came)
                  return came.error();
              const Result<std::vector<client::Model>> models = first->models();
              if (!models) return models.error();
              EXPECT_EQ(models->at(5).devices.front(),
                        (client::DeviceAddress{port(2), wire::position2d::kCode, 1}));
              EXPECT_EQ(models->at(6).devices.front(),
                        (client::DeviceAddress{port(3), wire::position2d::kCode, 0}));
              Result<Client> driver = connect(3);
              if (!driver) return driver.error();
              if (const auto driven = drive_a_metre(*driver, 0); !driven) return driven;
              const Result<client::Pose> pose = world->pose("six");
              if (!pose) return pose.error();
              EXPECT_GE(pose->x, 1);
              EXPECT_EQ(pose->y, 22);
              return {};
            }),
            "");
}

/// The log lines since it was made.
class LinesOfLog {
 public:
  LinesOfLog() {
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_)));
  }
  ~LinesOfLog() { spdlog::set_default_logger(before_); }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::shared_ptr<spdlog::logger> before_ = spdlog::default_logger();
};

/// `playhouse robot` with the bug "bob", in a thread of its own.
class Bob {
 public:
  explicit Bob(std::uint16_t server_port) : client_(program(), options(server_port), {desc()}) {
    client_.begin();
    program_ = std::thread([this] {
      code_ = service_.run();
      if (!is_listening_) listening_.set_value(early_end());
    });
  }
  ~Bob() {
    service_.loop().post([this] { service_.end(kDone); });
    if (program_.joinable()) program_.join();
  }
  /// To his port, once he has joined.
  Result<Client> connect() {
    const Result<std::uint16_t> port = listening_.get_future().get();
    if (!port) return port.error();
    return Client::connect("127.0.0.1", *port);
  }
  /// The exit code.
  int wait() {
    program_.join();
    return code_;
  }

 private:
  static Error early_end() { return {"bob", "ended before he joined"}; }
  app::RobotsClient::ServingProgram program() {
    auto program = app::serving_program(service_, 0);
    program.listen = [this](std::uint16_t wanted) {
      const Result<std::uint16_t> port = service_.listen(wanted);
      is_listening_ = true;
      listening_.set_value(port);
      return port;
    };
    return program;
  }
  static app::RobotsClient::RobotsClientOptions options(std::uint16_t server_port) {
    app::RobotsClient::RobotsClientOptions options;
    options.host = options.bind = "127.0.0.1";
    options.server_port = server_port;
    options.port = 0;
    return options;
  }
  static scene::RobotDesc desc() {
    scene::RobotDesc bob;
    bob.where = "bob.toml:1";
    bob.type = "bug";
    bob.name = "bob";
    bob.X_WR = {20, 0, 0, 0};
    return bob;
  }

  app::DeviceService service_{app::Serving{.bind = "127.0.0.1"}};
  std::promise<Result<std::uint16_t>> listening_;
  bool is_listening_ = false;  // thread of the program
  app::RobotsClient client_;
  std::atomic<int> code_ = -1;
  std::thread program_;
};

// Bob is robot 5, and no other has a ranger.
TEST_F(FollowingPorts, let_a_robot_join_by_the_one_of_its_wheels_without_what_is_elsewhere) {
  ASSERT_EQ(prepare(0), "");
  const LinesOfLog log;
  EXPECT_EQ(run_beside([&]() -> Result<void> {
              Bob bob(port(2));
              Result<Client> driver = bob.connect();
              if (!driver) return driver.error();
              const Result<std::vector<client::DeviceEntry>> devices = driver->devices();
              if (!devices) return devices.error();
              std::vector<std::string> names;
              for (const client::DeviceEntry& each : *devices) names.push_back(each.name());
              EXPECT_THAT(names, UnorderedElementsAre("position2d:0", "position3d:0", "speech:0",
                                                      "speech_recognition:0", "laser:0"));
              return drive_a_metre(*driver, 0);
            }),
            "");
  EXPECT_THAT(log.text(),
              HasSubstr(fmt::format(
                  "\"bob\" has devices on other ports of the server, left out: {}:ranger:0\n", port(0))));
}

TEST_F(FollowingPorts, send_a_robot_that_joins_by_another_to_the_one_of_its_wheels) {
  ASSERT_EQ(prepare(0), "");
  const LinesOfLog log;
  EXPECT_EQ(run_beside([&]() -> Result<void> {
              EXPECT_EQ(Bob(port(0)).wait(), kFailed);
              return {};
            }),
            "");
  EXPECT_THAT(log.text(),
              HasSubstr(fmt::format("\"bob\" has devices on port {0} of the server: --server 127.0.0.1:{0}\n",
                                    port(2))));
}

TEST_F(FollowingPorts, in_use_refuse_the_run_before_it_starts_and_none_later) {
  net::IoLoop other;
  const std::uint16_t first = first_of_free_ports(4);
  const auto listen = [&](int port) {
    return other.listen("127.0.0.1", static_cast<std::uint16_t>(port), [](auto) {});
  };
  {
    const auto taken = listen(first + 1);
    ASSERT_TRUE(taken);
    const std::string why = prepare(first);
    EXPECT_THAT(why, HasSubstr(fmt::format("127.0.0.1:{}: cannot listen", first + 1)));
    EXPECT_THAT(why, HasSubstr(fmt::format(
                         "the devices of 5 robots need 3 ports, from {} on; --port takes others", first)));
  }
  ASSERT_EQ(prepare(first), "");
  const auto taken = listen(first + 3);
  ASSERT_TRUE(taken);
  EXPECT_EQ(run_beside([&]() -> Result<void> {
              Result<Client> first = connect(0);
              if (!first) return first.error();
              Result<client::Simulation> world = client::Simulation::open(*first, 0);
              if (!world) return world.error();
              for (const char* name : {"five", "six", "seven"})
                if (const auto came = world->spawn("r0", {0, 20.0 + 2 * name[2], 0}, name); !came)
                  return came.error();
              const Result<std::vector<client::Model>> models = first->models();
              if (!models) return models.error();
              EXPECT_EQ(models->at(5).devices.front(),
                        (client::DeviceAddress{port(2), wire::position2d::kCode, 1}));
              EXPECT_TRUE(models->at(6).devices.empty());
              EXPECT_TRUE(models->at(7).devices.empty());
              return {};
            }),
            "");
}

TEST_F(FollowingPorts, end_with_the_last_number_of_a_port) {
  const std::string why = prepare(65535);
  EXPECT_THAT(
      why, AnyOf(StrEq("port 65536: the last port is 65535; the devices of 5 robots need 3 ports, from 65535 "
                       "on; --port takes others"),
                 StartsWith("127.0.0.1:65535: cannot listen")))
      << "or another program has it";
}

}  // namespace
}  // namespace playhouse
