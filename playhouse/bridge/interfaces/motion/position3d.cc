/// A robot as interface position3d: position2d plus height, roll and pitch (docs/drivers.md).

#include "playhouse/wire/generated/position3d.h"

#include <cmath>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/motion/drive_settings.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {
namespace {

namespace changes = world::changes;
namespace p3d = wire::position3d;
using geom::Vec3;
using wire::MessageType;

/// Odometry with the true height and tilt, which it does not estimate.
wire::Pose3d believed(const world::World& world, world::ModelRow model, world::PositionRow row) {
  geom::SpatialPose X{world.positions.X_OM[row], world.models.tilt_WM[model]};
  X.X.z = world.models.X_WM[model].z;
  return pose3d(X);
}

/// Velocity in its own frame: of its body in 3D, as commanded in 2D.
wire::Pose3d moving(const world::World& world, world::ModelRow model, world::PositionRow row) {
  const geom::Twist& driven = world.positions.velocity[row];
  if (world.upright || world.models.root[model] != model)
    return {driven.x, driven.y, driven.z, 0, 0, driven.a};
  geom::Quaternion q = geom::orientation(world.models.X_WM[model].a, world.models.tilt_WM[model]);
  q = {q.w, -q.x, -q.y, -q.z};
  const geom::SpatialVelocity& V = world.models.V_WM[model];
  const Vec3 v = q * V.v, w = q * V.w;
  return {v.x, v.y, v.z, w.x, w.y, w.z};
}

bool are_finite(const wire::Pose3d& v) {
  return std::isfinite(v.px) && std::isfinite(v.py) && std::isfinite(v.pyaw);
}

class Position3d final : public DriveDevice {
 public:
  Position3d(run::Simulation& simulation, world::ModelRow model)
      : DriveDevice(simulation, model), update_ticks_(world::update_ticks(simulation.world(), model)) {
    const scene::ModelDesc& desc = simulation.world().desc(model);
    geometry_ = wire::encode(p3d::Geom{pose3d(desc.X_MB), bbox3d(desc.size)});
  }

  std::span<const Served> served() const override;
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool acts(std::uint8_t request) const override { return request == p3d::kReqMotorPower; }
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  std::optional<world::Change> meaning(const device::Message& message) const;
  void set_odometry(const wire::Pose3d& X_OM, device::Replier replier) const;

  std::uint64_t update_ticks_;
  Bytes geometry_;
};

std::span<const Served> Position3d::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kCmd, p3d::kCmdSetVel},       {MessageType::kCmd, p3d::kCmdSetPos},
      {MessageType::kReq, p3d::kReqGetGeom},      {MessageType::kReq, p3d::kReqMotorPower},
      {MessageType::kReq, p3d::kReqVelocityMode}, {MessageType::kReq, p3d::kReqPositionMode},
      {MessageType::kReq, p3d::kReqSetOdom},      {MessageType::kReq, p3d::kReqResetOdom},
      {MessageType::kReq, p3d::kReqSpeedPid},     {MessageType::kReq, p3d::kReqPositionPid},
      {MessageType::kReq, p3d::kReqSpeedProf},
  };
  return kServed;
}

/// Shares the command slot with position2d: the latest command applies.
device::Taken Position3d::command(const device::Message& message) {
  std::optional<world::Change> command = meaning(message);
  if (!command) return device::Taken::kNo;
  simulation().requests().command(*std::move(command));
  return device::Taken::kLatest;
}

std::optional<world::Change> Position3d::meaning(const device::Message& message) const {
  if (message.subtype == p3d::kCmdSetVel) {
    const auto value = wire::decode<p3d::CmdVel>(message.body);
    if (!value || !are_finite(value->vel)) return std::nullopt;
    return changes::Drive{model(), {value->vel.px, value->vel.py, 0, value->vel.pyaw}};
  }
  const auto value = wire::decode<p3d::CmdPos>(message.body);
  if (!value || !world::is_place({value->pos.px, value->pos.py, 0, value->pos.pyaw})) return std::nullopt;
  return changes::DriveTo{model(), {value->pos.px, value->pos.py, 0, value->pos.pyaw}};
}

void Position3d::request(const device::Message& message, device::Replier replier) {
  switch (message.subtype) {
    case p3d::kReqGetGeom:
      return replier.ack(geometry_);
    case p3d::kReqVelocityMode:
    case p3d::kReqPositionMode:
      return replier.ack();  // the command implies the mode
    case p3d::kReqSpeedPid:
      return set_gains<p3d::SpeedPidReq>(message, true, std::move(replier));
    case p3d::kReqPositionPid:
      return set_gains<p3d::PositionPidReq>(message, false, std::move(replier));
    case p3d::kReqSpeedProf:
      if (const auto value = wire::decode<p3d::SpeedProfReq>(message.body))
        limit_way(value->speed, value->acc, &geom::Twist::a, std::move(replier));
      return;
    case p3d::kReqResetOdom:
      return set_odometry({}, std::move(replier));
    case p3d::kReqSetOdom:
      if (const auto value = wire::decode<p3d::SetOdomReq>(message.body))
        set_odometry(value->pos, std::move(replier));
      return;
    default:  // MOTOR_POWER
      if (const auto value = wire::decode<p3d::PowerConfig>(message.body))
        change_world(std::move(replier), changes::PowerWheels{model(), value->state != 0});
      return;
  }
}

void Position3d::set_odometry(const wire::Pose3d& X, device::Replier replier) const {
  change_world(std::move(replier), changes::SetOdometry{model(), {X.px, X.py, 0, X.pyaw}});
}

void Position3d::emit(const world::World& world, std::vector<device::Publication>& out) {
  if (world.tick() % update_ticks_ != 0) return;
  const world::ModelRow at = world.row(model());
  if (!at) return;
  const world::PositionRow row = world.models.part[at];
  publish(world, p3d::kDataState,
          p3d::Data{believed(world, at, row), moving(world, at, row), world.positions.stall[row]}, out);
}

}  // namespace

std::unique_ptr<SimulatedDevice> make_position3d_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Position3d>(simulation, model);
}

}  // namespace playhouse::drivers
