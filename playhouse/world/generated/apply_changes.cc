// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.

#include "playhouse/world/generated/changes.h"
#include "playhouse/world/traits.h"

namespace playhouse::world::changes {

bool apply(World& world, const Place& change) {
  const ModelRow model = world.row(change.model);
  return model && carry_out(world, model, change);
}

bool apply(World& world, const PlaceIn3D& change) {
  const ModelRow model = world.row(change.model);
  return model && carry_out(world, model, change);
}

bool apply(World& world, const SetColor& change) {
  const ModelRow model = world.row(change.model);
  return model && carry_out(world, model, change);
}

bool apply(World& world, const SetFiducial& change) {
  const ModelRow model = world.row(change.model);
  return model && carry_out(world, model, change);
}

bool apply(World& world, const Say& change) {
  const ModelRow model = world.row(change.model);
  return model && carry_out(world, model, change);
}

bool apply(World& world, const Subscribe& change) {
  const ModelRow model = world.row(change.model);
  return model && carry_out(world, model, change);
}

bool apply(World& world, const Unsubscribe& change) {
  const ModelRow model = world.row(change.model);
  return model && carry_out(world, model, change);
}

bool apply(World& world, const Watch& change) {
  const ModelRow model = world.row(change.model);
  return model && carry_out(world, model, change);
}

bool apply(World& world, const Unwatch& change) {
  const ModelRow model = world.row(change.model);
  return model && carry_out(world, model, change);
}

bool apply(World& world, const Drive& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kPosition) return false;
  return carry_out(world, PositionRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const DriveTo& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kPosition) return false;
  return carry_out(world, PositionRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const DriveHeading& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kPosition) return false;
  return carry_out(world, PositionRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const Stand& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kPosition) return false;
  return carry_out(world, PositionRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const SetOdometry& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kPosition) return false;
  return carry_out(world, PositionRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const PowerWheels& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kPosition) return false;
  return carry_out(world, PositionRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const SwitchLight& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kBlinkenlight) return false;
  return carry_out(world, BlinkenlightRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const FlashLight& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kBlinkenlight) return false;
  return carry_out(world, BlinkenlightRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const SwitchIndicator& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kLightindicator) return false;
  return carry_out(world, LightindicatorRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const Grip& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kGripper) return false;
  return carry_out(world, GripperRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const MoveJoint& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kActuator) return false;
  return carry_out(world, ActuatorRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const MoveJointTo& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kActuator) return false;
  return carry_out(world, ActuatorRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const PowerJoint& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kActuator) return false;
  return carry_out(world, ActuatorRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const BrakeJoint& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kActuator) return false;
  return carry_out(world, ActuatorRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const SetJointSpeed& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kActuator) return false;
  return carry_out(world, ActuatorRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const Send& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kWifi) return false;
  return carry_out(world, WifiRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const PointCamera& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kCamera) return false;
  return carry_out(world, CameraRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const ControlCamera& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kCamera) return false;
  return carry_out(world, CameraRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const CommandCustom& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kCustom) return false;
  return carry_out(world, CustomRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const SetAttitudeReference& change) {
  const ModelRow model = world.row(change.model);
  if (!model || world.models.kind[model.index] != scene::ModelKind::kImu) return false;
  return carry_out(world, ImuRow{world.models.part[model.index]}, change);
}

bool apply(World& world, const SetCharging& change) {
  const ModelRow model = world.row(change.model);
  if (!model) return false;
  const PackRow row{trait_row(world.packs, model.index)};
  return row && carry_out(world, row, change);
}

}  // namespace playhouse::world::changes
