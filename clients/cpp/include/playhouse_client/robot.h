#pragma once

/// A robot by name: the devices of a model and its subtree.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse_client/actarray.h"
#include "playhouse_client/aio.h"
#include "playhouse_client/blinkenlight.h"
#include "playhouse_client/blobfinder.h"
#include "playhouse_client/bumper.h"
#include "playhouse_client/camera.h"
#include "playhouse_client/fiducial.h"
#include "playhouse_client/gps.h"
#include "playhouse_client/gripper.h"
#include "playhouse_client/imu.h"
#include "playhouse_client/laser.h"
#include "playhouse_client/localize.h"
#include "playhouse_client/map.h"
#include "playhouse_client/model.h"
#include "playhouse_client/opaque.h"
#include "playhouse_client/planner.h"
#include "playhouse_client/pointcloud3d.h"
#include "playhouse_client/position2d.h"
#include "playhouse_client/position3d.h"
#include "playhouse_client/power.h"
#include "playhouse_client/ptz.h"
#include "playhouse_client/ranger.h"
#include "playhouse_client/sonar.h"
#include "playhouse_client/speech.h"
#include "playhouse_client/speech_recognition.h"
#include "playhouse_client/wifi.h"

namespace playhouse::client {

/// A device of a robot, and the model it represents.
struct RobotDevice {
  DeviceAddress address;
  std::string model;
};

/// Made by Client::robot() and Client::robots(). May outlive its client; opening then fails.
class Robot {
 public:
  const std::string& name() const { return name_; }
  /// Base type of the model, after macro expansion: "position".
  const std::string& type() const { return type_; }
  /// Devices on the connection's port: the model's own, then those of its subtree, in file order.
  const std::vector<RobotDevice>& devices() const { return devices_; }

  /// Opens the n-th device of an interface, n from 0. An error lists the devices there are.
  Result<Position2d> position2d(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Laser> laser(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Ranger> ranger(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Sonar> sonar(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Fiducial> fiducial(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Bumper> bumper(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Camera> camera(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Ptz> ptz(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Opaque> opaque(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Aio> aio(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Position3d> position3d(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Imu> imu(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Gps> gps(std::size_t n = 0, Access access = Access::kAll) const;
  Result<PointCloud3d> pointcloud3d(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Speech> speech(std::size_t n = 0, Access access = Access::kAll) const;
  Result<SpeechRecognition> speech_recognition(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Localize> localize(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Planner> planner(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Map> map(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Gripper> gripper(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Power> power(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Blobfinder> blobfinder(std::size_t n = 0, Access access = Access::kAll) const;
  Result<Wifi> wifi(std::size_t n = 0, Access access = Access::kAll) const;
  Result<ActArray> actarray(std::size_t n = 0, Access access = Access::kAll) const;
  Result<BlinkenLight> blinkenlight(std::size_t n = 0, Access access = Access::kAll) const;
  /// Opens a device of any interface, by the interface's name.
  Result<Device> device(std::string_view interf, std::size_t n = 0, Access access = Access::kAll) const;

 private:
  friend class Client;
  Robot(std::shared_ptr<Session> session, std::string name, std::string type,
        std::vector<RobotDevice> devices);
  template <typename Proxy>
  Result<Proxy> open(std::string_view interf, std::size_t n, Access access) const;

  std::shared_ptr<Session> session_;
  std::string name_, type_;
  std::vector<RobotDevice> devices_;
};

}  // namespace playhouse::client
