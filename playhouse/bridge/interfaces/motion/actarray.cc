/// An actuator as interface actarray: an array of one joint (docs/drivers.md).

#include <cmath>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/scene/forms/actuator.h"
#include "playhouse/wire/generated/actarray.h"
#include "playhouse/world/periods.h"
#include "playhouse/world/population/rows.h"

namespace playhouse::drivers {
namespace {

namespace act = wire::actarray;
namespace changes = world::changes;
using wire::MessageType;

/// The only joint, or all.
bool is_joint(std::int32_t joint) {
  return joint == 0 || joint == -1;
}

/// Pose of the joint at position 0 in its robot, in the world if none carries it.
geom::SpatialPose rest_on_robot(const world::World& world, world::ModelRow model) {
  const world::Models& models = world.models;
  geom::SpatialPose X = world::joint_of(world, models.part[model]);
  const world::ModelRow root = models.root[model];
  for (world::ModelRow row = models.parent[model]; row && row != root; row = models.parent[row])
    X = geom::compose(world::pose_in_parent(models, row), X);
  return X;
}

act::Geom geometry(const world::World& world, world::ModelRow model) {
  const scene::ActuatorDesc& desc = *world.desc(model).actuator;
  const scene::Axis axis = scene::axis_of(desc);
  const bool turns = desc.type == scene::ActuatorType::kRotational;
  act::Actuatorgeom joint;
  joint.type = static_cast<std::uint8_t>(turns ? act::kTypeRotary : act::kTypeLinear);
  joint.axis = {axis.x, axis.y, axis.z};
  joint.min = static_cast<float>(desc.min_position);
  joint.centre = static_cast<float>(0.5 * (desc.min_position + desc.max_position));
  joint.max = static_cast<float>(desc.max_position);
  joint.home = static_cast<float>(desc.start_position);
  joint.hasbrakes = 1;
  const wire::Pose3d X_RJ = pose3d(rest_on_robot(world, model));
  return {{joint}, {X_RJ.px, X_RJ.py, X_RJ.pz}, {X_RJ.proll, X_RJ.ppitch, X_RJ.pyaw}};
}

std::int32_t state_of(const world::Actuators& actuators, world::ActuatorRow row) {
  if (actuators.braked[row]) return act::kActstateBraked;
  if (actuators.stall[row]) return act::kActstateStalled;
  return actuators.velocity[row] != 0 ? act::kActstateMoving : act::kActstateIdle;
}

class Actarray final : public SimulatedDevice {
 public:
  Actarray(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)),
        update_ticks_(world::update_ticks(simulation.world(), model)),
        desc_(*simulation.world().desc(model).actuator),
        geometry_(geometry(simulation.world(), model)) {}

  world::ModelId robot() const override { return model(); }
  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kCmd, act::kCmdPos},    {MessageType::kCmd, act::kCmdMultiPos},
        {MessageType::kCmd, act::kCmdSpeed},  {MessageType::kCmd, act::kCmdMultiSpeed},
        {MessageType::kCmd, act::kCmdHome},   {MessageType::kReq, act::kReqPower},
        {MessageType::kReq, act::kReqBrakes}, {MessageType::kReq, act::kReqGetGeom},
        {MessageType::kReq, act::kReqSpeed},  {MessageType::kReq, act::kReqAccel},
    };
    return kServed;
  }

  device::Taken command(const device::Message& message) override {
    std::optional<world::Change> command = meaning(message);
    if (!command) return device::Taken::kNo;
    simulation().requests().command(*std::move(command));
    return device::Taken::kLatest;
  }

  void request(const device::Message& message, device::Replier replier) override {
    switch (message.subtype) {
      case act::kReqGetGeom:
        ask_world(
            std::move(replier),
            [id = model(), geometry = geometry_](const world::World& world) mutable -> std::optional<Bytes> {
              const world::ModelRow model = world.row(id);
              if (!model) return std::nullopt;
              const double speed = world.actuators.speed[world.models.part[model]];
              geometry.actuators[0].config_speed = static_cast<float>(speed);
              return wire::encode(geometry);
            });
        return;
      case act::kReqPower:
        if (const auto value = wire::decode<act::PowerConfig>(message.body))
          change_world(std::move(replier), changes::PowerJoint{model(), value->value != 0});
        return;
      case act::kReqBrakes:
        if (const auto value = wire::decode<act::BrakesConfig>(message.body))
          change_world(std::move(replier), changes::BrakeJoint{model(), value->value != 0});
        return;
      case act::kReqAccel:
        if (const auto value = wire::decode<act::AccelConfig>(message.body); value && is_joint(value->joint))
          change_world(std::move(replier),
                       changes::SetJointAcceleration{model(), static_cast<double>(value->accel)});
        return;
      default:  // SPEED
        if (const auto value = wire::decode<act::SpeedConfig>(message.body);
            value && is_joint(value->joint) && can_go_at(value->speed))
          change_world(std::move(replier), changes::SetJointSpeed{model(), value->speed});
        return;
    }
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    if (world.tick() % update_ticks_ != 0) return;
    const world::ModelRow model = world.row(this->model());
    if (!model) return;
    const world::Actuators& actuators = world.actuators;
    const world::KindRow row = world.models.part[model];
    act::Actuator joint;
    joint.position = static_cast<float>(actuators.position[row]);
    joint.speed = actuators.stall[row] ? 0 : static_cast<float>(actuators.velocity[row]);
    joint.current = -1;
    joint.state = static_cast<std::uint8_t>(state_of(actuators, row));
    publish(world, act::kDataState, act::Data{{joint}, actuators.motor_on[row]}, out);
  }

  void closed(world::Journal& journal) override {
    journal.apply(changes::PowerJoint{model(), true});
    journal.apply(changes::BrakeJoint{model(), false});
    journal.apply(changes::SetJointSpeed{model(), desc_.max_speed});
    const world::World& world = journal.world();
    if (world.actuators.acceleration[world.models.part[world.row(model())]] != 0)
      journal.apply(changes::SetJointAcceleration{model(), 0});
  }

 private:
  bool can_go_at(float speed) const { return speed > 0 && speed <= static_cast<float>(desc_.max_speed); }

  std::optional<world::Change> go_to(double position) const {
    if (!std::isfinite(position)) return std::nullopt;
    return changes::MoveJointTo{model(), position};
  }
  std::optional<world::Change> move_at(double velocity) const {
    if (!std::isfinite(velocity)) return std::nullopt;
    return changes::MoveJoint{model(), velocity};
  }

  /// The change that a command requests; none if invalid.
  std::optional<world::Change> meaning(const device::Message& message) const {
    switch (message.subtype) {
      case act::kCmdPos:
        if (const auto value = wire::decode<act::PositionCmd>(message.body); value && value->joint == 0)
          return go_to(value->position);
        return std::nullopt;
      case act::kCmdMultiPos:
        if (const auto value = wire::decode<act::MultiPositionCmd>(message.body);
            value && value->positions.size() == 1)
          return go_to(value->positions[0]);
        return std::nullopt;
      case act::kCmdSpeed:
        if (const auto value = wire::decode<act::SpeedCmd>(message.body); value && value->joint == 0)
          return move_at(value->speed);
        return std::nullopt;
      case act::kCmdMultiSpeed:
        if (const auto value = wire::decode<act::MultiSpeedCmd>(message.body);
            value && value->speeds.size() == 1)
          return move_at(value->speeds[0]);
        return std::nullopt;
      default:  // HOME
        if (const auto value = wire::decode<act::HomeCmd>(message.body); value && is_joint(value->joint))
          return go_to(desc_.start_position);
        return std::nullopt;
    }
  }

  std::uint64_t update_ticks_;
  scene::ActuatorDesc desc_;
  act::Geom geometry_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_actarray_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Actarray>(simulation, model);
}

}  // namespace playhouse::drivers
