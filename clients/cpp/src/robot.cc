#include "playhouse_client/robot.h"

#include <utility>

#include "model_list.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse_client/client.h"
#include "session.h"

namespace playhouse::client {

Robot::Robot(std::shared_ptr<Session> session, std::string name, std::string type,
             std::vector<RobotDevice> devices)
    : session_(std::move(session)),
      name_(std::move(name)),
      type_(std::move(type)),
      devices_(std::move(devices)) {}

Result<Device> Robot::device(std::string_view interf, std::size_t n, Access access) const {
  const wire::InterfaceDef* wanted = wire::find_interface(interf);
  if (wanted == nullptr) {
    std::vector<std::string_view> names;
    for (const wire::InterfaceDef& known : wire::interfaces()) names.push_back(known.name);
    return Error{"", "there is no interface " + in_quotes(interf) + did_you_mean(interf, names)};
  }
  std::size_t found = 0;
  std::string all;
  for (const RobotDevice& device : devices_) {
    all += (all.empty() ? "" : ", ") + device.address.name();
    if (device.address.interf != wanted->code) continue;
    if (found++ == n) return Device::open(session_, wanted->code, device.address.index, access);
  }
  const std::string missing = found == 0
                                  ? " has no " + std::string(interf)
                                  : " has " + std::to_string(found) + " " + std::string(interf) + " only";
  return Error{
      "", "robot " + in_quotes(name_) + missing + " (it has " + (all.empty() ? "no devices" : all) + ")"};
}

template <typename Proxy>
Result<Proxy> Robot::open(std::string_view interf, std::size_t n, Access access) const {
  Result<Device> opened = device(interf, n, access);
  if (!opened) return opened.error();
  return Proxy(std::move(*opened));
}

Result<Position2d> Robot::position2d(std::size_t n, Access access) const {
  return open<Position2d>("position2d", n, access);
}

Result<Laser> Robot::laser(std::size_t n, Access access) const {
  return open<Laser>("laser", n, access);
}

Result<Ranger> Robot::ranger(std::size_t n, Access access) const {
  Result<Device> opened = device("ranger", n, access);
  if (!opened) return opened.error();
  return Ranger::prepare(std::move(*opened));
}

Result<Sonar> Robot::sonar(std::size_t n, Access access) const {
  return open<Sonar>("sonar", n, access);
}

Result<Fiducial> Robot::fiducial(std::size_t n, Access access) const {
  return open<Fiducial>("fiducial", n, access);
}

Result<Bumper> Robot::bumper(std::size_t n, Access access) const {
  return open<Bumper>("bumper", n, access);
}

Result<Camera> Robot::camera(std::size_t n, Access access) const {
  return open<Camera>("camera", n, access);
}

Result<Ptz> Robot::ptz(std::size_t n, Access access) const {
  return open<Ptz>("ptz", n, access);
}

Result<Opaque> Robot::opaque(std::size_t n, Access access) const {
  return open<Opaque>("opaque", n, access);
}

Result<Aio> Robot::aio(std::size_t n, Access access) const {
  return open<Aio>("aio", n, access);
}

Result<Position3d> Robot::position3d(std::size_t n, Access access) const {
  return open<Position3d>("position3d", n, access);
}

Result<Imu> Robot::imu(std::size_t n, Access access) const {
  return open<Imu>("imu", n, access);
}

Result<Gps> Robot::gps(std::size_t n, Access access) const {
  return open<Gps>("gps", n, access);
}

Result<PointCloud3d> Robot::pointcloud3d(std::size_t n, Access access) const {
  return open<PointCloud3d>("pointcloud3d", n, access);
}

Result<Speech> Robot::speech(std::size_t n, Access access) const {
  return open<Speech>("speech", n, access);
}

Result<SpeechRecognition> Robot::speech_recognition(std::size_t n, Access access) const {
  return open<SpeechRecognition>("speech_recognition", n, access);
}

Result<Localize> Robot::localize(std::size_t n, Access access) const {
  return open<Localize>("localize", n, access);
}

Result<Planner> Robot::planner(std::size_t n, Access access) const {
  return open<Planner>("planner", n, access);
}

Result<Map> Robot::map(std::size_t n, Access access) const {
  return open<Map>("map", n, access);
}

Result<Gripper> Robot::gripper(std::size_t n, Access access) const {
  return open<Gripper>("gripper", n, access);
}

Result<Power> Robot::power(std::size_t n, Access access) const {
  return open<Power>("power", n, access);
}

Result<Blobfinder> Robot::blobfinder(std::size_t n, Access access) const {
  return open<Blobfinder>("blobfinder", n, access);
}

Result<Wifi> Robot::wifi(std::size_t n, Access access) const {
  return open<Wifi>("wifi", n, access);
}

Result<ActArray> Robot::actarray(std::size_t n, Access access) const {
  return open<ActArray>("actarray", n, access);
}

Result<BlinkenLight> Robot::blinkenlight(std::size_t n, Access access) const {
  return open<BlinkenLight>("blinkenlight", n, access);
}

}  // namespace playhouse::client
