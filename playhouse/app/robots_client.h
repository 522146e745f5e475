#pragma once

/// RobotsClient: robots of this machine in the world of another one. One connection brings them there and
/// relays their devices; when it ends they leave.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/app/device_service.h"
#include "playhouse/drivers/passthrough/passthrough.h"
#include "playhouse/scene/robot_file.h"

namespace playhouse::app {

class RobotsClient {
 public:
  struct Options {
    std::string host;  // of the world's server
    std::uint16_t server_port = 6665;
    std::string bind;           // of the ports here
    std::uint16_t port = 6665;  // of the first robot that names none, the next ones follow; 0: any free ones
  };
  /// `service`, in which it opens the site, outlives it.
  RobotsClient(DeviceService& service, Options options, std::vector<scene::RobotDesc> robots);

  /// Begins to connect. What goes wrong ends the service, with one line.
  void begin();

 private:
  struct Robot {
    scene::RobotDesc desc;
    std::string name;  // in the world
    std::vector<drivers::RemoteDevice> devices;
    bool joined = false, gone = false;
    unsigned missed = 0;  // times in a row that the server did not know it
  };

  void bring_next();
  void came(Robot& robot, std::string name);
  void serve(Robot& robot, const std::string& devices);
  void retired(drivers::RemoteDevice device);
  void look_after();
  void gone(Robot& robot);
  Result<std::uint16_t> open_port(const Robot& robot);
  /// The address here of the robot's next device of an interface.
  device::Address address_of(const Robot& robot, std::uint16_t port, std::uint16_t interf) const;
  void fail_with(const Error& error);

  DeviceService& service_;
  Options options_;
  std::vector<Robot> robots_;
  std::size_t next_ = 0;  // to be brought
  std::uint16_t next_port_;
  drivers::Passthrough* relay_;
  std::unique_ptr<net::Timer> look_after_;
};

}  // namespace playhouse::app
