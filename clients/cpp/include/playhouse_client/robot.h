#pragma once

/// A robot by name: the devices of a model and its subtree.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse_client/model.h"
#include "playhouse_client/robot_devices.h"

namespace playhouse::client {

/// A device of a robot, and the model it represents.
struct RobotDevice {
  DeviceAddress address;
  std::string model;
};

/// Made by Client::robot() and Client::robots(). May outlive its client; opening then fails.
class Robot final : public RobotDevices {
 public:
  const std::string& name() const { return name_; }
  /// Base type of the model, after macro expansion: "position".
  const std::string& type() const { return type_; }
  /// Devices on the connection's port: the model's own, then those of its subtree, in file order.
  const std::vector<RobotDevice>& devices() const { return devices_; }

  /// Opens a device of any interface, by the interface's name.
  Result<Device> device(std::string_view interf, std::size_t n = 0,
                        Access access = Access::kAll) const override;

 private:
  friend class Client;
  Robot(std::shared_ptr<Session> session, std::string name, std::string type,
        std::vector<RobotDevice> devices);

  std::shared_ptr<Session> session_;
  std::string name_, type_;
  std::vector<RobotDevice> devices_;
};

}  // namespace playhouse::client
