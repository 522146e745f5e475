#include "playhouse/drivers/interfaces/position2d.h"

#include <algorithm>
#include <cmath>

#include "playhouse/base/log.h"
#include "playhouse/drivers/interfaces/shapes.h"
#include "playhouse/run/velocity_command.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;
using wire::MessageType;

namespace {

template <typename... Number>
bool are_finite(Number... number) {
  return (std::isfinite(number) && ...);
}

/// Speed and heading control in the odometry frame. [m/s, rad]
run::Change heading_command(world::ModelId robot, double speed, double heading_O) {
  return [=](world::World& world) {
    if (const world::PositionRow row = world.position(robot))
      world::command_heading(world, row, speed, heading_O);
  };
}

}  // namespace

run::Change goal_command(world::ModelId robot, const geom::Pose& goal_O) {
  return [=](world::World& world) {
    if (const world::PositionRow row = world.position(robot)) world::command_position(world, row, goal_O);
  };
}

bool set_odometry_of(world::World& world, world::ModelId robot, const geom::Pose& X_OM) {
  const world::PositionRow row = world.position(robot);
  return row && world::set_odometry(world, row, X_OM);
}

bool set_motor(world::World& world, world::ModelId robot, bool on) {
  const world::PositionRow row = world.position(robot);
  if (row) world.positions.motor_on[row.index] = on;
  return static_cast<bool>(row);
}

Position2d::Position2d(run::Simulation& simulation, world::ModelRow model)
    : SimulatedDevice(simulation, simulation.world().id(model)),
      update_ticks_(world::update_ticks(simulation.world(), model)) {
  const scene::ModelDesc& desc = simulation.world().desc(model);
  geometry_ = wire::encode(p2d::Geom{pose3d(desc.X_MB), bbox3d(desc.size)});
}

std::span<const Served> Position2d::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kCmd, p2d::kCmdVel},          {MessageType::kCmd, p2d::kCmdPos},
      {MessageType::kCmd, p2d::kCmdCar},          {MessageType::kCmd, p2d::kCmdVelHead},
      {MessageType::kReq, p2d::kReqGetGeom},      {MessageType::kReq, p2d::kReqMotorPower},
      {MessageType::kReq, p2d::kReqPositionMode}, {MessageType::kReq, p2d::kReqSetOdom},
      {MessageType::kReq, p2d::kReqResetOdom},
  };
  return kServed;
}

bool Position2d::acts(std::uint8_t request) const {
  return request == p2d::kReqMotorPower;
}

device::Taken Position2d::command(const device::Message& message) {
  run::Change command = meaning(message);
  if (!command) return device::Taken::kNo;
  simulation().command({model(), p2d::kCode}, std::move(command));
  return device::Taken::kLatest;
}

run::Change Position2d::meaning(const device::Message& message) const {
  switch (message.subtype) {
    case p2d::kCmdVel:
      if (const auto value = wire::decode<p2d::CmdVel>(message.body);
          value && are_finite(value->vel.px, value->vel.py, value->vel.pa))
        return run::velocity_command(model(), {value->vel.px, value->vel.py, 0, value->vel.pa});
      return {};
    case p2d::kCmdCar:
      if (const auto value = wire::decode<p2d::CmdCar>(message.body);
          value && are_finite(value->velocity, value->angle))
        return run::velocity_command(model(), {value->velocity, 0, 0, value->angle});
      return {};
    case p2d::kCmdPos:
      if (const auto value = wire::decode<p2d::CmdPos>(message.body);
          value && world::is_place({value->pos.px, value->pos.py, 0, value->pos.pa}))
        return goal_command(model(), {value->pos.px, value->pos.py, 0, value->pos.pa});
      return {};
    default:  // VEL_HEAD
      if (const auto value = wire::decode<p2d::CmdVelHead>(message.body);
          value && are_finite(value->velocity, value->angle))
        return heading_command(model(), value->velocity, value->angle);
      return {};
  }
}

void Position2d::request(const device::Message& message, device::Replier replier) {
  switch (message.subtype) {
    case p2d::kReqGetGeom:
      replier.ack(geometry_);
      return;
    case p2d::kReqPositionMode:
      replier.ack();
      return;  // the command implies the mode
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
        ask_world(std::move(replier),
                  [id = model(), on = value->state != 0](world::World& world) -> std::optional<Bytes> {
                    if (!set_motor(world, id, on)) return std::nullopt;
                    return Bytes();
                  });
      }
      return;
    default:
      return;  // the replier sends NACK
  }
}

void Position2d::set_odometry(const geom::Pose& X_OM, device::Replier replier) {
  ask_world(std::move(replier), [id = model(), X_OM](world::World& world) -> std::optional<Bytes> {
    if (!set_odometry_of(world, id, X_OM)) return std::nullopt;
    return Bytes();
  });
}

void Position2d::emit(const world::World& world, std::vector<device::Publication>& out) {
  if (world.tick() % update_ticks_ != 0) return;
  const world::PositionRow robot = world.position(model());
  if (!robot) return;
  const world::Positions& positions = world.positions;
  const std::uint32_t row = robot.index;
  publish(world, p2d::kDataState,
          p2d::Data{pose2d(positions.X_OM[row]), pose2d(positions.velocity[row]), positions.stall[row]}, out);
}

void Position2d::closed(world::World& world, world::ModelRow model) {
  world.positions.motor_on[world.models.part[model.index]] = 1;
}

std::unique_ptr<SimulatedDevice> make_position2d_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Position2d>(simulation, model);
}

}  // namespace playhouse::drivers
