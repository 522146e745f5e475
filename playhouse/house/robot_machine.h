#pragma once

/// RobotMachine: another machine of a simulated house, on which `playhouse robot` brings a robot into the world and serves
/// its devices to a client. Thread: one for the whole house.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/app/commands/robots_client.h"
#include "playhouse/device_server/server_host.h"
#include "playhouse/drivers/site.h"
#include "playhouse/house/client.h"
#include "playhouse/house/process.h"
#include "playhouse/net/simulated.h"
#include "playhouse/server/server.h"

namespace playhouse::house {

class RobotMachine final : private device_server::ServerHost {
 public:
  /// Brings a robot of this name from a port of its own to the world's; the seed decides where to.
  RobotMachine(net::SimulatedNetwork& network, std::uint16_t world_port, std::uint16_t port,
               const std::string& name, double period, std::uint64_t seed);

  void act();
  void hear();
  void excuse_until(double time);
  /// Its client asks no more.
  void finish();
  /// It has ended by itself: the world took no robot, or is gone.
  bool is_over() const { return over_; }
  std::size_t answered() const { return client_ ? client_->answered() : 0; }
  std::size_t waits_for() const { return client_ ? client_->waits_for() : 0; }
  std::uint64_t digest() const { return client_ ? client_->digest() : 0; }
  std::optional<std::string> fault() const { return client_ ? client_->fault() : std::nullopt; }

 private:
  // device_server::ServerHost
  server::Server& the_server() override { return server_; }
  net::Network& the_network() override { return network_; }
  bool has_threads() const override { return false; }

  net::SimulatedNetwork& all_;  // machines
  Process network_;
  const std::uint16_t port_;
  const double period_;
  const std::uint64_t seed_;
  drivers::Site site_;
  std::vector<std::unique_ptr<device::Driver>> drivers_;
  server::Server server_;
  std::unique_ptr<app::RobotsClient> robots_;
  std::optional<SimulatedClient> client_;  // once the port is open
  double excused_until_ = 0;               // s
  bool serves_ = false, finishes_ = false, over_ = false;
};

}  // namespace playhouse::house
