// The server in front of a simulated world whose tick takes long: what waits for the tick is shared fairly.
// No sockets, no threads: the test is the tick.

#include <gtest/gtest.h>

#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse {
namespace {

using server::TestClient;
namespace simulation = wire::simulation;

constexpr std::uint16_t kPort = 6665;
constexpr std::uint16_t kWheels = wire::position2d::kCode, kSimulation = simulation::kCode;

class BusyTick : public ::testing::Test {
 protected:
  BusyTick()
      : still_("interval_sim 100\nposition( name \"r0\" )\n"),
        driver_(still_.devices, "stage"),
        server_(network_) {
    EXPECT_EQ(*server_.listen(kPort), kPort);
    driver_.add(*server_.add_device({kPort, kWheels, 0}, driver_),
                drivers::make_device(still_.devices, kWheels, still_.world().find("r0")));
    driver_.add(*server_.add_device({kPort, kSimulation, 0}, driver_),
                drivers::make_device(still_.devices, kSimulation, {}));
  }
  // What still waits may hold repliers.
  ~BusyTick() override { still_.simulation.discard(); }

  /// The client sends `bytes` so often, and the tick comes only then.
  void flood(TestClient& client, const Bytes& bytes, std::size_t times) {
    for (std::size_t i = 0; i < times; ++i) client.send(bytes);
    network_.run();
  }
  void tick() {
    still_.run(1);
    network_.run();
  }
  /// What another client hears of a request that has to wait for the tick.
  std::string heard_by_another() {
    TestClient other(network_, kPort);
    const Bytes pose = wire::encode(simulation::Pose2dReq{wire::c_string("r0"), {}});
    auto heard =
        other.ask(server::message(wire::MessageType::kReq, kSimulation, 0, simulation::kReqGetPose2d, pose));
    tick();
    for (server::Received& more : other.read()) heard.push_back(std::move(more));
    return server::outline(heard);
  }

  net::SimulatedNetwork network_{3};
  drivers::testing::StillDevices still_;
  drivers::SimulatedDriver driver_;
  server::Server server_;
};

TEST_F(BusyTick, a_client_that_opens_and_closes_without_end_leaves_room_for_the_requests_of_others) {
  TestClient busy(network_, kPort);
  Bytes pair = server::open_request(kWheels, 0);
  const Bytes close = server::open_request(kWheels, 0, 2);
  pair.insert(pair.end(), close.begin(), close.end());
  flood(busy, pair, limits::kRequestQueue);
  EXPECT_EQ(heard_by_another(), "ACK 1");
}

TEST_F(BusyTick, a_client_that_resets_the_world_without_end_leaves_room_for_the_requests_of_others) {
  TestClient busy(network_, kPort);
  flood(busy, server::message(wire::MessageType::kCmd, kSimulation, 0, simulation::kCmdReset),
        2 * limits::kRequestQueue);
  EXPECT_EQ(heard_by_another(), "ACK 1");
}

TEST_F(BusyTick, all_that_a_client_sent_is_carried_out_although_it_had_to_wait) {
  TestClient busy(network_, kPort);
  flood(busy, server::open_request(kWheels, 0), 1);
  for (std::size_t i = 0; i < limits::kRequestQueue; ++i)
    busy.send(server::message(wire::MessageType::kCmd, kSimulation, 0, simulation::kCmdReset));
  flood(busy, server::open_request(kWheels, 0, 2), 1);
  EXPECT_EQ(server::outline(busy.read()), "ACK 3");
  for (std::size_t ticks = 0; ticks <= limits::kRequestQueue / limits::kSessionAnswers; ++ticks) tick();
  const std::vector<server::Received> heard = busy.read();
  ASSERT_FALSE(heard.empty());
  EXPECT_EQ(heard.back().header.type, wire::MessageType::kAck) << "that of the close, behind the data";
}

}  // namespace
}  // namespace playhouse
