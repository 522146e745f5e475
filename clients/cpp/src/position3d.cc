#include "playhouse_client/position3d.h"

#include <utility>

#include "convert.h"
#include "done.h"
#include "finite.h"

namespace playhouse::client {

namespace position3d = wire::position3d;

namespace {

Result<void> finite_pose(const Device& device, std::string_view what, const Pose3d& p) {
  return finite(device, what, {p.x, p.y, p.z, p.roll, p.pitch, p.yaw});
}

}  // namespace

Result<Position3d> Position3d::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, position3d::kCode, index, access);
  if (!device) return device.error();
  return Position3d(std::move(*device));
}

Position3d& Position3d::operator=(Position3d&& other) noexcept {
  if (this == &other) return *this;
  static_cast<void>(close().ok());
  device_ = std::move(other.device_);
  moving_ = other.moving_;
  return *this;
}

Position3d::~Position3d() {
  static_cast<void>(close().ok());
}

std::optional<Position3d::State> Position3d::state() const {
  const auto data = device_.latest<position3d::Data>(position3d::kDataState);
  if (!data) return std::nullopt;
  return State{client::pose(data->pos), client::pose(data->vel), data->stall != 0, device_.timestamp()};
}

Result<void> Position3d::drive(double vx, double va, double vy, double vz) {
  if (const auto sound = finite(device_, "drive", {vx, va, vy, vz}); !sound) return sound;
  moving_ = vx != 0.0 || vy != 0.0 || vz != 0.0 || va != 0.0;
  position3d::CmdVel command;
  command.vel = on_wire(Pose3d{vx, vy, vz, 0, 0, va});
  command.state = 1;
  return device_.command(position3d::kCmdSetVel, command);
}

Result<void> Position3d::go_to(const Pose3d& pose) {
  if (const auto sound = finite_pose(device_, "go_to", pose); !sound) return sound;
  moving_ = true;
  position3d::CmdPos command;
  command.pos = on_wire(pose);
  command.state = 1;
  return device_.command(position3d::kCmdSetPos, command);
}

Result<void> Position3d::set_motor_power(bool on) {
  return done(
      device_.request(position3d::kReqMotorPower, position3d::PowerConfig{static_cast<std::uint8_t>(on)}));
}

Result<void> Position3d::set_odometry(const Pose3d& pose) {
  if (const auto sound = finite_pose(device_, "set_odometry", pose); !sound) return sound;
  return done(device_.request(position3d::kReqSetOdom, position3d::SetOdomReq{on_wire(pose)}));
}

Result<void> Position3d::reset_odometry() {
  return done(device_.request(position3d::kReqResetOdom));
}

Result<Geometry> Position3d::geometry() {
  const auto geom = device_.request<position3d::Geom>(position3d::kReqGetGeom);
  if (!geom) return geom.error();
  return Geometry{client::pose(geom->pose), size(geom->size)};
}

Result<void> Position3d::close() {
  return stop_and_close(*this, moving_);
}

}  // namespace playhouse::client
