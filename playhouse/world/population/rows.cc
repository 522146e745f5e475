#include "playhouse/world/population/rows.h"

#include "playhouse/base/rng.h"
#include "playhouse/scene/forms/actuator.h"
#include "playhouse/scene/forms/camera.h"
#include "playhouse/scene/forms/charge.h"
#include "playhouse/world/columns.h"
#include "playhouse/world/generated/worded.h"
#include "playhouse/world/gripper.h"
#include "playhouse/world/traits.h"

namespace playhouse::world {
namespace {

template <typename T>
std::uint32_t count32(const std::vector<T>& column) {
  return static_cast<std::uint32_t>(column.size());
}

geom::Twist draw_odometry_error(const World& world, ModelRow model) {
  Rng rng(world.seed(), 0, {Purpose::kOdometryError, world.serial(model)});
  geom::Twist error;
  error.x = rng.uniform(-0.015, 0.015);
  error.y = rng.uniform(-0.015, 0.015);
  error.a = rng.uniform(-0.025, 0.025);
  return error;
}

}  // namespace

void fill_row(World& world, Positions& positions, const scene::ModelDesc& model, ModelRow row) {
  const scene::PositionDesc& desc = *model.position;
  positions.command.back() = desc.velocity;
  begin_odometry(world, positions.model.last());
  positions.odom_error.back() = desc.odom_error.value_or(draw_odometry_error(world, row));
  positions.motor_on.back() = 1;
}

void begin_odometry(World& world, PositionRow robot) {
  Positions& positions = world.positions;
  const ModelRow model = positions.model[robot];
  const scene::PositionDesc& desc = *world.desc(model).position;
  const geom::Pose& X_WM = world.models.X_WM[model];
  const bool gps = desc.localization == scene::Localization::kGps;
  const geom::Pose X_WO = desc.localization_origin.value_or(gps ? geom::Pose{} : X_WM);
  positions.X_OM[robot] = geom::compose(geom::inverse(X_WO), X_WM);
  positions.X_WO[robot] = X_WO;
}

void fill_row(World& world, Rangers& rangers, const scene::ModelDesc& model, ModelRow) {
  Sensors& sensors = world.sensors;
  const RangerRow ranger = rangers.model.last();
  rangers.first_sensor.back() = sensors.ranger.next();
  rangers.sensor_count.back() = count32(model.sensors);
  for (const scene::RangerSensorDesc& sensor : model.sensors) {
    sensors.ranger.push_back(ranger);
    sensors.first_beam.push_back(sensors.ranges.next());
    sensors.beam_count.push_back(sensor.samples);
    sensors.ranges.insert(sensors.ranges.end(), sensor.samples, static_cast<float>(sensor.range_max));
    sensors.intensities.insert(sensors.intensities.end(), sensor.samples, 0.0f);
  }
}

void fill_row(World&, Packs& packs, const scene::ModelDesc& model, ModelRow) {
  const scene::Charge charge = scene::charge_of(model);
  packs.stored.back() = charge.stored;
  packs.capacity.back() = charge.capacity;
  packs.takes.back() = 1;
  packs.gives.back() = 1;
}

void fill_row(World&, Blinkenlights& lamps, const scene::ModelDesc&, ModelRow) {
  lamps.lit.back() = lamps.enabled.back();
}

/// The file's pose is that at position 0.
void fill_row(World& world, Actuators& actuators, const scene::ModelDesc& model, ModelRow row) {
  actuators.speed.back() = model.actuator->max_speed;
  actuators.motor_on.back() = 1;
  set_joint(world, actuators.model.last(), pose_in_parent(world.models, row));
}

void set_joint(World& world, ActuatorRow actuator, const geom::SpatialPose& X_PJ) {
  Actuators& actuators = world.actuators;
  const ModelRow row = actuators.model[actuator];
  actuators.X_PJ[actuator] = X_PJ.X;
  const double position = actuators.position[actuator];
  const geom::SpatialPose X_PM =
      position == 0 ? X_PJ : geom::compose(X_PJ, {scene::way_along(*world.desc(row).actuator, position), {}});
  world.models.X_PM.set(row, X_PM.X);
  world.models.tilt_PM.set(row, X_PM.tilt);
  place(world.models, row);
}

geom::SpatialPose joint_of(const World& world, ActuatorRow actuator) {
  const Actuators& actuators = world.actuators;
  const ModelRow row = actuators.model[actuator];
  const scene::ActuatorDesc& desc = *world.desc(row).actuator;
  const geom::Tilt tilt = world.models.tilt_PM[row];
  const double position = actuators.position[actuator];
  const geom::Pose& X = actuators.X_PJ[actuator];
  if (tilt == geom::Tilt{} || desc.type == scene::ActuatorType::kLinear || position == 0) return {X, tilt};
  // A tilt is in M, which has turned.
  const geom::Vec2 in_J = geom::Rotation::of(scene::way_along(desc, position).a) * geom::Vec2{tilt.x, tilt.y};
  return {X, {in_J.x, in_J.y}};
}

void fill_row(World&, Grippers& grippers, const scene::ModelDesc& model, ModelRow) {
  grippers.paddles.back() = model.gripper->paddles == scene::Paddles::kClosed ? 1 : 0;
  grippers.lift.back() = model.gripper->lift == scene::Lift::kUp ? 1 : 0;
  grippers.close_limit.back() = 1;
}

void fill_row(World&, Cameras& cameras, const scene::ModelDesc& model, ModelRow) {
  cameras.mode.back() = ControlMode::kPosition;
  cameras.pan.back() = cameras.goal_pan.back() = model.camera->pan;
  cameras.tilt.back() = cameras.goal_tilt.back() = model.camera->tilt;
  cameras.zoom.back() = cameras.goal_zoom.back() = model.camera->fov_horizontal;
}

bool say_row(const Packs& packs, PackRow row, const scene::ModelDesc& model, scene::ModelDesc* said) {
  const scene::Charge charge = scene::charge_of(model);
  if (charge.stored == packs.stored[row] && charge.capacity == packs.capacity[row]) return false;
  if (!said) return true;
  said->joules = packs.stored[row];
  said->joules_capacity = packs.capacity[row];
  said->kjoules = said->kjoules_capacity = {};
  return true;
}

bool say_row(const Grippers& grippers, GripperRow row, const scene::ModelDesc& model,
             scene::ModelDesc* said) {
  scene::GripperDesc standing = *model.gripper;
  const PaddleState state = paddle_state(grippers, row);
  if (state == PaddleState::kOpen) standing.paddles = scene::Paddles::kOpen;
  if (state == PaddleState::kClosed) standing.paddles = scene::Paddles::kClosed;
  const bool lift_rests = grippers.rising[row] == 0;
  if (lift_rests && grippers.lift[row] <= 0) standing.lift = scene::Lift::kDown;
  if (lift_rests && grippers.lift[row] >= 1) standing.lift = scene::Lift::kUp;
  if (standing == *model.gripper) return false;
  if (said) said->gripper = standing;
  return true;
}

bool say_row(const Cameras& cameras, CameraRow row, const scene::ModelDesc& model, scene::ModelDesc* said) {
  scene::CameraDesc looking = *model.camera;
  looking.pan = cameras.pan[row];
  looking.tilt = cameras.tilt[row];
  looking.fov_vertical = scene::vertical_fov(*model.camera, cameras.zoom[row]);
  looking.fov_horizontal = cameras.zoom[row];
  if (looking == *model.camera) return false;
  if (said) said->camera = looking;
  return true;
}

bool say_rows(const World& world, ModelRow row, scene::ModelDesc* said) {
  const scene::ModelDesc& model = world.desc(row);
  bool is_new = !is_as_said(world, row, model);
  if (is_new && said) say_as_is(world, row, *said);
  of_kind(model.kind, [&]<typename Table>(Table Tables::*table) {
    is_new |= say_row(world.*table, world.models.part[row], model, said);
  });
  each_trait_table([&]<typename Table>(Table Tables::*table) {
    if (kHas<Table>(model)) is_new |= say_row(world.*table, trait_row(world.*table, row), model, said);
  });
  return is_new;
}

const geom::Pose& pose_said(const World& world, const Actuators& actuators, ModelRow row) {
  return actuators.X_PJ[world.models.part[row]];
}

const geom::Pose& pose_said(const World& world, ModelRow row) {
  const geom::Pose* said = &world.models.X_PM[row];
  of_kind(world.models.kind[row],
          [&]<typename Table>(Table Tables::*table) { said = &pose_said(world, world.*table, row); });
  return *said;
}

void moved_in_parent(World& world, Actuators& actuators, ModelRow row) {
  const ActuatorRow actuator = world.models.part[row];
  const geom::Pose way = scene::way_along(*world.desc(row).actuator, actuators.position[actuator]);
  actuators.X_PJ[actuator] = geom::compose(pose_in_parent(world.models, row), {geom::inverse(way), {}}).X;
}

void moved_in_world(World& world, Positions& positions, ModelRow row) {
  if (world.desc(row).position->localization != scene::Localization::kGps) return;
  const PositionRow robot = world.models.part[row];
  positions.X_OM[robot] = geom::compose(geom::inverse(positions.X_WO[robot]), world.models.X_WM[row]);
}

}  // namespace playhouse::world
