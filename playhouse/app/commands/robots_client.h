#pragma once

/// RobotsClient: puts local robots into a remote world. One connection
/// spawns them and relays their devices; when it closes they are removed.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/passthrough/passthrough.h"
#include "playhouse/drivers/site.h"
#include "playhouse/net/network.h"
#include "playhouse/net/tls/tls_trust.h"
#include "playhouse/scene/robot_file.h"

namespace playhouse::app {

class DeviceService;

class RobotsClient {
 public:
  struct RobotsClientOptions {
    std::string host;  // of the remote server
    std::uint16_t server_port = 6665;
    std::string bind;           // address of the local ports
    std::uint16_t port = 6665;  // for the first robot without a port, counting up; 0: any free ones
    double patience = 30;       // s, for an answer while robots are brought
    std::string token;          // of a guest; empty: none
    std::shared_ptr<net::TlsTrust> trust = {};  // of the server; null: in the clear
  };
  /// The program that serves the robots' devices. Its site and network must outlive this.
  struct ServingProgram {
    drivers::Site& site;
    net::Network& network;
    std::function<void(std::unique_ptr<device::Driver>)> keep;        // a driver with devices in the site
    std::function<Result<std::uint16_t>(std::uint16_t port)> listen;  // opens a port; 0: any free one
    std::function<void(const std::string& line)> say;                 // where a robot's devices are
    std::function<void(const Error&)> failed;                         // once: there are no robots any more
  };
  RobotsClient(ServingProgram program, RobotsClientOptions options, std::vector<scene::RobotDesc> robots);

  /// Starts connecting.
  void begin();

 private:
  struct RemoteRobot {
    scene::RobotDesc desc;
    std::string name;  // in the world
    std::vector<drivers::RemoteDevice> devices;
    bool joined = false, gone = false;
    unsigned missed = 0;  // consecutive polls in which the server did not list it
  };

  void greet();
  void bring_next();
  void expect_answer();
  void came(RemoteRobot& robot, std::string name);
  void serve(RemoteRobot& robot, const std::string& devices);
  void retired(drivers::RemoteDevice device);
  void look_after();
  void gone(RemoteRobot& robot);
  Result<std::uint16_t> open_port(const RemoteRobot& robot);
  /// The local address of the robot's next device of an interface.
  device::Address address_of(const RemoteRobot& robot, std::uint16_t port, std::uint16_t interf) const;
  void fail_with(const Error& error);

  const ServingProgram program_;
  RobotsClientOptions options_;
  std::vector<RemoteRobot> robots_;
  std::size_t next_ = 0;  // next to be spawned
  std::uint16_t next_port_;
  drivers::Passthrough* relay_;
  bool failed_ = false;
  std::unique_ptr<net::Timer> look_after_, answer_;
};

/// Of the robots of a service, whose site is opened. Errors end the service, with one log line. It must outlive
/// the client.
RobotsClient::ServingProgram serving_program(DeviceService& service, std::uint16_t port);

}  // namespace playhouse::app
