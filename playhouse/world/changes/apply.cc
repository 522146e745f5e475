/// What each change does to the row of its model. In: changes of any origin, files and peers
/// included, so that every number and every count is checked here or by the function called.

#include <algorithm>
#include <cmath>

#include "playhouse/base/limits.h"
#include "playhouse/scene/properties.h"
#include "playhouse/world/camera.h"
#include "playhouse/world/drawing.h"
#include "playhouse/world/generated/changes.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/radio_messages.h"
#include "playhouse/world/saving/state.h"
#include "playhouse/world/traits.h"

namespace playhouse::world::changes {

// --- any model

bool carry_out(World& world, ModelRow row, const Place& change) {
  return set_pose(world, row, change.X_PM);
}

bool carry_out(World& world, ModelRow row, const PlaceIn3D& change) {
  return set_spatial_pose(world, row, change.X_PM);
}

bool carry_out(World& world, ModelRow row, const SetColor& change) {
  const scene::Color& c = change.color;
  if (!std::isfinite(c.r + c.g + c.b + c.a)) return false;
  set_color(world, row, c);
  return true;
}

bool carry_out(World& world, ModelRow row, const SetFiducial& change) {
  set_fiducial_return(world, row, change.id);
  return true;
}

bool carry_out(World& world, ModelRow row, const Say& change) {
  set_say(world, row, change.text);
  return true;
}

bool carry_out(World& world, ModelRow row, const Draw& change) {
  return draw(world, row, {change.layer, change.corners, change.color, change.points});
}

bool carry_out(World& world, ModelRow row, const ClearDrawing& change) {
  clear_drawing(world, row, change.layer);
  return true;
}

bool carry_out(World& world, ModelRow row, const Subscribe&) {
  if (world.models.subscribers[row] >= limits::kSubscribers) return false;
  subscribe(world, row);
  return true;
}

/// Those of controllers stay, and those of watchers end as such.
bool carry_out(World& world, ModelRow row, const Unsubscribe&) {
  const Models& models = world.models;
  const std::uint32_t others = models.controllers[row] + models.watchers[row];
  if (models.subscribers[row] <= others) return false;
  unsubscribe(world, row);
  return true;
}

bool carry_out(World& world, ModelRow row, const Watch&) {
  if (world.models.subscribers[row] >= limits::kSubscribers) return false;
  watch(world, row);
  return true;
}

bool carry_out(World& world, ModelRow row, const Unwatch&) {
  if (world.models.watchers[row] == 0) return false;
  unwatch(world, row);
  return true;
}

// --- robots

bool carry_out(World& world, PositionRow row, const Drive& change) {
  return command_velocity(world, row, change.velocity);
}

bool carry_out(World& world, PositionRow row, const DriveTo& change) {
  return command_position(world, row, change.goal_O);
}

bool carry_out(World& world, PositionRow row, const DriveHeading& change) {
  return command_heading(world, row, change.speed, change.heading_O);
}

bool carry_out(World& world, PositionRow row, const Stand&) {
  command_velocity(world, row, {});
  world.positions.velocity[row] = {};
  world.positions.stall[row] = 0;
  return true;
}

bool carry_out(World& world, PositionRow row, const SetOdometry& change) {
  return set_odometry(world, row, change.X_OM);
}

bool carry_out(World& world, PositionRow row, const PowerWheels& change) {
  world.positions.motor_on[row] = change.on;
  return true;
}

bool carry_out(World& world, PositionRow row, const LimitWay& change) {
  const auto is_limit = [](double value) { return value >= 0 && std::isfinite(value); };
  if (!is_limit(change.speed) || !is_limit(change.turn) || !is_limit(change.acceleration) ||
      !is_limit(change.turn_acceleration))
    return false;
  world.positions.speed_limit[row] = {change.speed, 0, 0, change.turn};
  world.positions.acceleration_limit[row] = {change.acceleration, 0, 0, change.turn_acceleration};
  return true;
}

// --- other kinds

bool carry_out(World& world, ActuatorRow row, const MoveJoint& change) {
  return command_joint_velocity(world, row, change.velocity);
}

bool carry_out(World& world, ActuatorRow row, const MoveJointTo& change) {
  return command_joint_position(world, row, change.position);
}

bool carry_out(World& world, ActuatorRow row, const PowerJoint& change) {
  world.actuators.motor_on[row] = change.on;
  return true;
}

bool carry_out(World& world, ActuatorRow row, const BrakeJoint& change) {
  world.actuators.braked[row] = change.on;
  return true;
}

bool carry_out(World& world, ActuatorRow row, const SetJointSpeed& change) {
  if (!(change.speed > 0)) return false;
  const scene::ActuatorDesc& desc = *world.desc(world.actuators.model[row]).actuator;
  world.actuators.speed[row] = std::min(change.speed, desc.max_speed);
  return true;
}

bool carry_out(World& world, ActuatorRow row, const SetJointAcceleration& change) {
  if (!(change.acceleration >= 0) || !std::isfinite(change.acceleration)) return false;
  world.actuators.acceleration[row] = change.acceleration;
  return true;
}

bool carry_out(World& world, CameraRow row, const PointCamera& change) {
  if (world.cameras.mode[row] == ControlMode::kVelocity)
    return turn_camera(world, row, change.pan_speed, change.tilt_speed);
  return aim_camera(world, row, {change.pan, change.tilt, change.zoom});
}

bool carry_out(World& world, CameraRow row, const ControlCamera& change) {
  set_camera_mode(world, row, change.by_velocity ? ControlMode::kVelocity : ControlMode::kPosition);
  return true;
}

bool carry_out(World& world, CameraRow row, const OpenStereo& change) {
  if (world.desc(world.cameras.model[row]).camera->baseline <= 0) return false;
  world.cameras.stereo_open[row] = change.open;
  return true;
}

bool carry_out(World& world, GripperRow row, const Grip& change) {
  command_gripper(world, row, change.command);
  return true;
}

bool carry_out(World& world, BlinkenlightRow row, const SwitchLight& change) {
  world.blinkenlights.enabled[row] = change.on;
  return true;
}

bool carry_out(World& world, BlinkenlightRow row, const FlashLight& change) {
  if (!std::isfinite(change.period) || change.period < 0) return false;
  if (!(change.dutycycle >= 0 && change.dutycycle <= 1)) return false;
  world.blinkenlights.period[row] = change.period;
  world.blinkenlights.dutycycle[row] = change.dutycycle;
  return true;
}

bool carry_out(World& world, LightindicatorRow row, const SwitchIndicator& change) {
  world.lightindicators.lit[row] = change.on;
  return true;
}

/// A number that is not there begins the model as well (custom_hooks.h), so it is a change.
bool carry_out(World& world, CustomRow row, const CommandCustom& change) {
  if (!std::isfinite(change.value)) return false;
  command_custom(world, row, change.which, change.value);
  return true;
}

/// What is dropped is counted, so it is a change as well.
bool carry_out(World& world, WifiRow row, const Send& change) {
  if (change.bytes.size() > limits::kRadioMessageBytes) return false;
  send_message(world, row, change.to, change.bytes);
  return true;
}

bool carry_out(World& world, ImuRow row, const SetAttitudeReference& change) {
  if (world.imus.noted_tick[row] == 0) return false;
  if (!std::isfinite(change.heading) || !geom::is_tilt(change.tilt)) return false;
  world.imus.reference_heading[row] = change.heading;
  world.imus.reference_tilt[row] = change.tilt;
  return true;
}

bool carry_out(World& world, MoteRow row, const WakeMote& change) {
  world.motes.awake[row] = change.awake;
  return true;
}

bool carry_out(World& world, MoteRow row, const SetReportRate& change) {
  if (!(change.frequency >= 0 && change.frequency <= scene::kLargestNumber)) return false;  // or NaN
  world.motes.frequency[row] = change.frequency;
  return true;
}

bool carry_out(World& world, PackRow row, const SetCharging& change) {
  world.packs.takes[row] = change.takes;
  world.packs.gives[row] = change.gives;
  return true;
}

// --- the world

namespace {

/// Spawns with ids from `first` on, if that is above those in use: after a state was loaded, no id names two
/// models. The gap is part of the state (world/population/serials.h), so a spawn that fails takes it back.
template <typename Make>
Result<ModelId> with_ids_from(World& world, std::uint32_t first, const Make& make) {
  Population population(world);
  const std::uint32_t before = population.next_id();
  if (!population.serials().add({before, first})) return make();
  population.next_id() = first;
  Result<ModelId> made = make();
  if (made) return made;
  population.next_id() = before;
  population.serials().remove_last();
  return made;
}

}  // namespace

Result<ModelId> apply(World& world, const Spawn& change) {
  return with_ids_from(world, change.first_id,
                       [&] { return spawn(world, change.prototype, change.X_WM, change.name); });
}

Result<ModelId> apply(World& world, const SpawnCopy& change) {
  const ModelRow model = world.row(change.of);
  if (!model) return Error{"", "the model to copy is gone"};
  return with_ids_from(world, change.first_id,
                       [&] { return spawn_like(world, model, change.X_WM, change.name); });
}

Result<void> apply(World& world, const Despawn& change) {
  return despawn(world, change.models);
}

Result<void> apply(World& world, const Attach& change) {
  if (change.children.size() != change.X_PC.size()) return Error{"", "a pose for each child is needed"};
  std::vector<AttachedChild> attachments;
  for (std::size_t i = 0; i < change.children.size(); ++i)
    attachments.push_back({change.children[i], change.X_PC[i]});
  return attach(world, attachments, change.parent);
}

Result<void> apply(World& world, const Detach& change) {
  return detach(world, change.models);
}

bool apply(World& world, const ReturnToStart&) {
  return_to_start(world);
  return true;
}

bool apply(World& world, const StartControllers&) {
  for (const std::unique_ptr<Decider>& decider : world.deciders) decider->follow(world);
  return true;
}

Result<void> apply(World& world, const Load& change) {
  if (change.state == nullptr) return Error{"", "there is no state to load"};
  return load_state(world, *change.state, change.seed);
}

}  // namespace playhouse::world::changes

namespace playhouse::world {

bool apply(World& world, const Change& change) {
  return std::visit([&](const auto& made) { return static_cast<bool>(changes::apply(world, made)); }, change);
}

}  // namespace playhouse::world
