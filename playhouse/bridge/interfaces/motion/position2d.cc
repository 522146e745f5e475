#include "playhouse/bridge/interfaces/motion/position2d.h"

#include <algorithm>
#include <cmath>

#include "playhouse/base/log.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {

namespace changes = world::changes;
namespace p2d = wire::position2d;
using wire::MessageType;

namespace {

template <typename... Number>
bool are_finite(Number... number) {
  return (std::isfinite(number) && ...);
}

}  // namespace

Position2d::Position2d(run::Simulation& simulation, world::ModelRow model)
    : DriveDevice(simulation, model), update_ticks_(world::update_ticks(simulation.world(), model)) {
  const scene::ModelDesc& desc = simulation.world().desc(model);
  geometry_ = wire::encode(p2d::Geom{pose3d(desc.X_MB), bbox3d(desc.size)});
}

std::span<const Served> Position2d::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kCmd, p2d::kCmdVel},          {MessageType::kCmd, p2d::kCmdPos},
      {MessageType::kCmd, p2d::kCmdCar},          {MessageType::kCmd, p2d::kCmdVelHead},
      {MessageType::kReq, p2d::kReqGetGeom},      {MessageType::kReq, p2d::kReqMotorPower},
      {MessageType::kReq, p2d::kReqPositionMode}, {MessageType::kReq, p2d::kReqSetOdom},
      {MessageType::kReq, p2d::kReqResetOdom},    {MessageType::kReq, p2d::kReqVelocityMode},
      {MessageType::kReq, p2d::kReqSpeedPid},     {MessageType::kReq, p2d::kReqPositionPid},
      {MessageType::kReq, p2d::kReqSpeedProf},
  };
  return kServed;
}

bool Position2d::acts(std::uint8_t request) const {
  return request == p2d::kReqMotorPower;
}

device::Taken Position2d::command(const device::Message& message) {
  std::optional<world::Change> command = meaning(message);
  if (!command) return device::Taken::kNo;
  simulation().requests().command(*std::move(command));
  return device::Taken::kLatest;
}

std::optional<world::Change> Position2d::meaning(const device::Message& message) const {
  switch (message.subtype) {
    case p2d::kCmdVel:
      if (const auto value = wire::decode<p2d::CmdVel>(message.body);
          value && are_finite(value->vel.px, value->vel.py, value->vel.pa))
        return changes::Drive{model(), {value->vel.px, value->vel.py, 0, value->vel.pa}};
      return std::nullopt;
    case p2d::kCmdCar:
      if (const auto value = wire::decode<p2d::CmdCar>(message.body);
          value && are_finite(value->velocity, value->angle))
        return changes::Drive{model(), {value->velocity, 0, 0, value->angle}};
      return std::nullopt;
    case p2d::kCmdPos:
      if (const auto value = wire::decode<p2d::CmdPos>(message.body);
          value && world::is_place({value->pos.px, value->pos.py, 0, value->pos.pa}))
        return changes::DriveTo{model(), {value->pos.px, value->pos.py, 0, value->pos.pa}};
      return std::nullopt;
    default:  // VEL_HEAD
      if (const auto value = wire::decode<p2d::CmdVelHead>(message.body);
          value && are_finite(value->velocity, value->angle))
        return changes::DriveHeading{model(), value->velocity, value->angle};
      return std::nullopt;
  }
}

void Position2d::request(const device::Message& message, device::Replier replier) {
  switch (message.subtype) {
    case p2d::kReqGetGeom:
      replier.ack(geometry_);
      return;
    case p2d::kReqPositionMode:
    case p2d::kReqVelocityMode:
      replier.ack();
      return;  // the command implies the mode
    case p2d::kReqSpeedPid:
      return set_gains<p2d::SpeedPidReq>(message, true, std::move(replier));
    case p2d::kReqPositionPid:
      return set_gains<p2d::PositionPidReq>(message, false, std::move(replier));
    case p2d::kReqSpeedProf:
      if (const auto value = wire::decode<p2d::SpeedProfReq>(message.body))
        limit_way(value->speed, value->acc, &geom::Twist::x, std::move(replier));
      return;
    case p2d::kReqResetOdom:
      set_odometry({}, std::move(replier));
      return;
    case p2d::kReqSetOdom:
      if (const auto value = wire::decode<p2d::SetOdomReq>(message.body)) {
        set_odometry({value->pose.px, value->pose.py, 0, value->pose.pa}, std::move(replier));
      }
      return;
    case p2d::kReqMotorPower:
      if (const auto value = wire::decode<p2d::PowerConfig>(message.body)) {
        change_world(std::move(replier), changes::PowerWheels{model(), value->state != 0});
      }
      return;
    default:
      return;  // the replier sends NACK
  }
}

void Position2d::set_odometry(const geom::Pose& X_OM, device::Replier replier) {
  change_world(std::move(replier), changes::SetOdometry{model(), X_OM});
}

void Position2d::emit(const world::World& world, std::vector<device::Publication>& out) {
  if (world.tick() % update_ticks_ != 0) return;
  const world::PositionRow robot = world.position(model());
  if (!robot) return;
  const world::Positions& positions = world.positions;
  const world::PositionRow row = robot;
  publish(world, p2d::kDataState,
          p2d::Data{pose2d(positions.X_OM[row]), pose2d(positions.velocity[row]), positions.stall[row]}, out);
}

std::unique_ptr<SimulatedDevice> make_position2d_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Position2d>(simulation, model);
}

}  // namespace playhouse::drivers
