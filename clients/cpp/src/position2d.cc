#include "playhouse_client/position2d.h"

#include <utility>

#include "convert.h"
#include "done.h"
#include "finite.h"
#include "refusal.h"

namespace playhouse::client {

namespace position2d = wire::position2d;

Result<Position2d> Position2d::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, position2d::kCode, index, access);
  if (!device) return device.error();
  return Position2d(std::move(*device));
}

Position2d& Position2d::operator=(Position2d&& other) noexcept {
  if (this == &other) return *this;
  static_cast<void>(close().ok());
  device_ = std::move(other.device_);
  moving_ = other.moving_;
  return *this;
}

Position2d::~Position2d() {
  static_cast<void>(close().ok());
}

std::optional<Position2d::State> Position2d::state() const {
  const auto data = device_.latest<position2d::Data>(position2d::kDataState);
  if (!data) return std::nullopt;
  return State{client::pose(data->pos), client::velocity(data->vel), data->stall != 0, device_.timestamp()};
}

Result<void> Position2d::drive(double vx, double va, double vy) {
  if (const auto sound = finite(device_, "drive", {vx, va, vy}); !sound) return sound;
  moving_ = vx != 0.0 || vy != 0.0 || va != 0.0;
  position2d::CmdVel command;
  command.vel = {vx, vy, va};
  command.state = 1;
  return device_.command(position2d::kCmdVel, command);
}

Result<void> Position2d::drive_car(double speed, double steering) {
  if (const auto sound = finite(device_, "drive_car", {speed, steering}); !sound) return sound;
  moving_ = speed != 0.0;
  return device_.command(position2d::kCmdCar, position2d::CmdCar{speed, steering});
}

Result<void> Position2d::go_to(const Pose& pose, double speed) {
  if (const auto sound = finite(device_, "go_to", {pose.x, pose.y, pose.a, speed}); !sound) return sound;
  moving_ = true;
  position2d::CmdPos command;
  command.pos = on_wire(pose);
  command.vel.px = speed;
  command.state = 1;
  return device_.command(position2d::kCmdPos, command);
}

Result<std::string> Position2d::why_refused() {
  return refusal_of(device_);
}

Result<void> Position2d::set_motor_power(bool on) {
  return done(
      device_.request(position2d::kReqMotorPower, position2d::PowerConfig{static_cast<std::uint8_t>(on)}));
}

Result<void> Position2d::set_odometry(const Pose& pose) {
  if (const auto sound = finite(device_, "set_odometry", {pose.x, pose.y, pose.a}); !sound) return sound;
  return done(device_.request(position2d::kReqSetOdom, position2d::SetOdomReq{on_wire(pose)}));
}

Result<void> Position2d::reset_odometry() {
  return done(device_.request(position2d::kReqResetOdom));
}

Result<Geometry> Position2d::geometry() {
  const auto geom = device_.request<position2d::Geom>(position2d::kReqGetGeom);
  if (!geom) return geom.error();
  return Geometry{client::pose(geom->pose), size(geom->size)};
}

Result<void> Position2d::close() {
  return stop_and_close(*this, moving_);
}

}  // namespace playhouse::client
