// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The changes of a world between two ticks: a closed list. Journal::apply() alone makes them in a run,
/// and keeps them in order; docs/changes.md lists them. Poses are by frames as in world.h.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/gripper.h"

namespace playhouse::world {

namespace changes {

/// Teleports the model in its parent's frame, without collision check; attached models follow. Its tilt
/// stays.
struct Place {
  static constexpr std::string_view kName = "place";
  ModelId model;
  geom::Pose X_PM;  // m, m, m, rad
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("X_PM", self.X_PM);
  }
};

/// The same with a tilt, which engines that keep models upright ignore.
struct PlaceIn3D {
  static constexpr std::string_view kName = "place_in_3d";
  ModelId model;
  geom::SpatialPose X_PM;  // m, m, m, rad; tilt rad, rad
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("X_PM", self.X_PM);
  }
};

/// Sets the color.
struct SetColor {
  static constexpr std::string_view kName = "set_color";
  ModelId model;
  scene::Color color;  // 0 to 1
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("color", self.color);
  }
};

/// Sets the fiducial_return.
struct SetFiducial {
  static constexpr std::string_view kName = "set_fiducial";
  ModelId model;
  std::int32_t id = 0;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("id", self.id);
  }
};

/// Sets the text that the model says, made one line of UTF-8; empty for nothing.
struct Say {
  static constexpr std::string_view kName = "say";
  ModelId model;
  std::string text;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("text", self.text);
  }
};

/// One more uses the model: sensors measure and motors move while somebody does.
struct Subscribe {
  static constexpr std::string_view kName = "subscribe";
  ModelId model;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
  }
};

/// One less uses the model. The last one stops a robot or an actuator. Fails if there is no user left to
/// count.
struct Unsubscribe {
  static constexpr std::string_view kName = "unsubscribe";
  ModelId model;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
  }
};

/// One more reads the model, which draws no power for it.
struct Watch {
  static constexpr std::string_view kName = "watch";
  ModelId model;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
  }
};

/// One less reads the model. Fails if nobody does.
struct Unwatch {
  static constexpr std::string_view kName = "unwatch";
  ModelId model;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
  }
};

/// Velocity command, in the frame of the robot.
struct Drive {
  static constexpr std::string_view kName = "drive";
  ModelId model;
  geom::Twist velocity;  // m/s, m/s, m/s, rad/s
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("velocity", self.velocity);
  }
};

/// Position command: a goal in the odometry frame.
struct DriveTo {
  static constexpr std::string_view kName = "drive_to";
  ModelId model;
  geom::Pose goal_O;  // m, m, m, rad
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("goal_O", self.goal_O);
  }
};

/// Drives at a speed while turning to a heading in the odometry frame.
struct DriveHeading {
  static constexpr std::string_view kName = "drive_heading";
  ModelId model;
  double speed = 0;  // m/s
  double heading_O = 0;  // rad
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("speed", self.speed);
    visit("heading_O", self.heading_O);
  }
};

/// Stops at once: command, velocity and stall are cleared.
struct Stand {
  static constexpr std::string_view kName = "stand";
  ModelId model;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
  }
};

/// Sets the odometry: the robot believes to be at X_OM.
struct SetOdometry {
  static constexpr std::string_view kName = "set_odometry";
  ModelId model;
  geom::Pose X_OM;  // m, m, m, rad
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("X_OM", self.X_OM);
  }
};

/// Switches the motor.
struct PowerWheels {
  static constexpr std::string_view kName = "power_wheels";
  ModelId model;
  bool on = false;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("on", self.on);
  }
};

/// Switches the lamp.
struct SwitchLight {
  static constexpr std::string_view kName = "switch_light";
  ModelId model;
  bool on = false;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("on", self.on);
  }
};

/// Sets period and duty cycle of the lamp. Fails unless the period is not negative and the duty cycle within
/// 0 and 1.
struct FlashLight {
  static constexpr std::string_view kName = "flash_light";
  ModelId model;
  double period = 0;  // s
  double dutycycle = 0;  // 1
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("period", self.period);
    visit("dutycycle", self.dutycycle);
  }
};

/// Switches the light.
struct SwitchIndicator {
  static constexpr std::string_view kName = "switch_indicator";
  ModelId model;
  bool on = false;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("on", self.on);
  }
};

/// Commands paddles or lift.
struct Grip {
  static constexpr std::string_view kName = "grip";
  ModelId model;
  GripperCommand command = GripperCommand::kOpen;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("command", self.command);
  }
};

/// Velocity command, within the limits on speed and position.
struct MoveJoint {
  static constexpr std::string_view kName = "move_joint";
  ModelId model;
  double velocity = 0;  // m/s or rad/s
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("velocity", self.velocity);
  }
};

/// Position command, clamped to the range.
struct MoveJointTo {
  static constexpr std::string_view kName = "move_joint_to";
  ModelId model;
  double position = 0;  // m or rad
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("position", self.position);
  }
};

/// Switches the motor.
struct PowerJoint {
  static constexpr std::string_view kName = "power_joint";
  ModelId model;
  bool on = false;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("on", self.on);
  }
};

/// Sets or releases the brake.
struct BrakeJoint {
  static constexpr std::string_view kName = "brake_joint";
  ModelId model;
  bool on = false;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("on", self.on);
  }
};

/// Sets the speed of position commands; the maximum if it is above. Fails unless positive.
struct SetJointSpeed {
  static constexpr std::string_view kName = "set_joint_speed";
  ModelId model;
  double speed = 0;  // m/s or rad/s
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("speed", self.speed);
  }
};

/// Queues a message for the next tick: to one radio, or to all in reach if to is no model. It is dropped and
/// counted if the queue is full. Fails if it is too long.
struct Send {
  static constexpr std::string_view kName = "send";
  ModelId model;
  ModelId to;
  std::vector<std::uint8_t> bytes;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("to", self.to);
    visit("bytes", self.bytes);
  }
};

/// Command of pan, tilt and zoom: a target with their position under position control, speeds under velocity
/// control.
struct PointCamera {
  static constexpr std::string_view kName = "point_camera";
  ModelId model;
  double pan = 0;  // rad
  double tilt = 0;  // rad
  double zoom = 0;  // rad
  double pan_speed = 0;  // rad/s
  double tilt_speed = 0;  // rad/s
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("pan", self.pan);
    visit("tilt", self.tilt);
    visit("zoom", self.zoom);
    visit("pan_speed", self.pan_speed);
    visit("tilt_speed", self.tilt_speed);
  }
};

/// Sets velocity or position control; a change of it stops the camera.
struct ControlCamera {
  static constexpr std::string_view kName = "control_camera";
  ModelId model;
  bool by_velocity = false;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("by_velocity", self.by_velocity);
  }
};

/// Sets a number of the command of a custom model, if it has so many.
struct CommandCustom {
  static constexpr std::string_view kName = "command_custom";
  ModelId model;
  std::uint32_t which = 0;
  double value = 0;  // V
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("which", self.which);
    visit("value", self.value);
  }
};

/// Sets the attitude that the unit calls level and ahead. Fails before its first measurement.
struct SetAttitudeReference {
  static constexpr std::string_view kName = "set_attitude_reference";
  ModelId model;
  double heading = 0;  // rad
  geom::Tilt tilt;  // rad, rad
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("heading", self.heading);
    visit("tilt", self.tilt);
  }
};

/// Whether the battery takes charge, and gives any.
struct SetCharging {
  static constexpr std::string_view kName = "set_charging";
  ModelId model;
  bool takes = false;
  bool gives = false;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("model", self.model);
    visit("takes", self.takes);
    visit("gives", self.gives);
  }
};

/// Spawns a tree of the prototype in this row of the scene's models, at X_WM. Without a name, that of the
/// prototype with a number. Ids count from first_id on if that is above those in use. Fails on an invalid
/// prototype or pose, a name in use, and at a limit.
struct Spawn {
  static constexpr std::string_view kName = "spawn";
  std::uint32_t prototype = 0;
  geom::Pose X_WM;  // m, m, m, rad
  std::string name;
  std::uint32_t first_id = 0;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("prototype", self.prototype);
    visit("X_WM", self.X_WM);
    visit("name", self.name);
    visit("first_id", self.first_id);
  }
};

/// Spawns a copy of the tree that a model is in, with the color and the fiducial of its root, at the root's
/// height. Otherwise as spawn.
struct SpawnCopy {
  static constexpr std::string_view kName = "spawn_copy";
  ModelId of;
  geom::Pose X_WM;  // m, m, m, rad
  std::string name;
  std::uint32_t first_id = 0;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("of", self.of);
    visit("X_WM", self.X_WM);
    visit("name", self.name);
    visit("first_id", self.first_id);
  }
};

/// Removes roots with all their own parts, all or none; models attached to them stay in place.
struct Despawn {
  static constexpr std::string_view kName = "despawn";
  std::vector<ModelId> models;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("models", self.models);
  }
};

/// Attaches roots to a model, upright in it, at their poses X_PC in it; all or none.
struct Attach {
  static constexpr std::string_view kName = "attach";
  std::vector<ModelId> children;
  ModelId parent;
  std::vector<geom::Pose> X_PC;  // m, m, m, rad
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("children", self.children);
    visit("parent", self.parent);
    visit("X_PC", self.X_PC);
  }
};

/// Detaches attached models, all or none: they become roots at their present poses.
struct Detach {
  static constexpr std::string_view kName = "detach";
  std::vector<ModelId> models;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("models", self.models);
  }
};

/// Resets every model to its pose in the scene, and commands and odometry to their initial values. Time goes
/// on.
struct ReturnToStart {
  static constexpr std::string_view kName = "return_to_start";
  template <typename Self, typename Visit>
  static void each_field(Self&, const Visit&) {}
};

/// Starts the controllers of models that came, and lets go those of models that went.
struct StartControllers {
  static constexpr std::string_view kName = "start_controllers";
  template <typename Self, typename Visit>
  static void each_field(Self&, const Visit&) {}
};

/// Loads another state of the run, and goes on from there with this seed.
struct Load {
  static constexpr std::string_view kName = "load";
  std::uint64_t seed = 0;
  std::shared_ptr<const std::vector<std::byte>> state;
  template <typename Self, typename Visit>
  static void each_field(Self& self, const Visit& visit) {
    visit("seed", self.seed);
    visit("state", self.state);
  }
};

/// Each applies one change. False, or a reason, and no effect: there is no such model of the kind, or as said
/// above.
bool apply(World& world, const Place& change);
bool apply(World& world, const PlaceIn3D& change);
bool apply(World& world, const SetColor& change);
bool apply(World& world, const SetFiducial& change);
bool apply(World& world, const Say& change);
bool apply(World& world, const Subscribe& change);
bool apply(World& world, const Unsubscribe& change);
bool apply(World& world, const Watch& change);
bool apply(World& world, const Unwatch& change);
bool apply(World& world, const Drive& change);
bool apply(World& world, const DriveTo& change);
bool apply(World& world, const DriveHeading& change);
bool apply(World& world, const Stand& change);
bool apply(World& world, const SetOdometry& change);
bool apply(World& world, const PowerWheels& change);
bool apply(World& world, const SwitchLight& change);
bool apply(World& world, const FlashLight& change);
bool apply(World& world, const SwitchIndicator& change);
bool apply(World& world, const Grip& change);
bool apply(World& world, const MoveJoint& change);
bool apply(World& world, const MoveJointTo& change);
bool apply(World& world, const PowerJoint& change);
bool apply(World& world, const BrakeJoint& change);
bool apply(World& world, const SetJointSpeed& change);
bool apply(World& world, const Send& change);
bool apply(World& world, const PointCamera& change);
bool apply(World& world, const ControlCamera& change);
bool apply(World& world, const CommandCustom& change);
bool apply(World& world, const SetAttitudeReference& change);
bool apply(World& world, const SetCharging& change);
Result<ModelId> apply(World& world, const Spawn& change);
Result<ModelId> apply(World& world, const SpawnCopy& change);
Result<void> apply(World& world, const Despawn& change);
Result<void> apply(World& world, const Attach& change);
Result<void> apply(World& world, const Detach& change);
bool apply(World& world, const ReturnToStart& change);
bool apply(World& world, const StartControllers& change);
Result<void> apply(World& world, const Load& change);

/// What those do with the row of the model, by hand in world/changes/.
bool carry_out(World& world, ModelRow row, const Place& change);
bool carry_out(World& world, ModelRow row, const PlaceIn3D& change);
bool carry_out(World& world, ModelRow row, const SetColor& change);
bool carry_out(World& world, ModelRow row, const SetFiducial& change);
bool carry_out(World& world, ModelRow row, const Say& change);
bool carry_out(World& world, ModelRow row, const Subscribe& change);
bool carry_out(World& world, ModelRow row, const Unsubscribe& change);
bool carry_out(World& world, ModelRow row, const Watch& change);
bool carry_out(World& world, ModelRow row, const Unwatch& change);
bool carry_out(World& world, PositionRow row, const Drive& change);
bool carry_out(World& world, PositionRow row, const DriveTo& change);
bool carry_out(World& world, PositionRow row, const DriveHeading& change);
bool carry_out(World& world, PositionRow row, const Stand& change);
bool carry_out(World& world, PositionRow row, const SetOdometry& change);
bool carry_out(World& world, PositionRow row, const PowerWheels& change);
bool carry_out(World& world, BlinkenlightRow row, const SwitchLight& change);
bool carry_out(World& world, BlinkenlightRow row, const FlashLight& change);
bool carry_out(World& world, LightindicatorRow row, const SwitchIndicator& change);
bool carry_out(World& world, GripperRow row, const Grip& change);
bool carry_out(World& world, ActuatorRow row, const MoveJoint& change);
bool carry_out(World& world, ActuatorRow row, const MoveJointTo& change);
bool carry_out(World& world, ActuatorRow row, const PowerJoint& change);
bool carry_out(World& world, ActuatorRow row, const BrakeJoint& change);
bool carry_out(World& world, ActuatorRow row, const SetJointSpeed& change);
bool carry_out(World& world, WifiRow row, const Send& change);
bool carry_out(World& world, CameraRow row, const PointCamera& change);
bool carry_out(World& world, CameraRow row, const ControlCamera& change);
bool carry_out(World& world, CustomRow row, const CommandCustom& change);
bool carry_out(World& world, ImuRow row, const SetAttitudeReference& change);
bool carry_out(World& world, PackRow row, const SetCharging& change);

}  // namespace changes

using Change = std::variant<
    changes::Place,
    changes::PlaceIn3D,
    changes::SetColor,
    changes::SetFiducial,
    changes::Say,
    changes::Subscribe,
    changes::Unsubscribe,
    changes::Watch,
    changes::Unwatch,
    changes::Drive,
    changes::DriveTo,
    changes::DriveHeading,
    changes::Stand,
    changes::SetOdometry,
    changes::PowerWheels,
    changes::SwitchLight,
    changes::FlashLight,
    changes::SwitchIndicator,
    changes::Grip,
    changes::MoveJoint,
    changes::MoveJointTo,
    changes::PowerJoint,
    changes::BrakeJoint,
    changes::SetJointSpeed,
    changes::Send,
    changes::PointCamera,
    changes::ControlCamera,
    changes::CommandCustom,
    changes::SetAttitudeReference,
    changes::SetCharging,
    changes::Spawn,
    changes::SpawnCopy,
    changes::Despawn,
    changes::Attach,
    changes::Detach,
    changes::ReturnToStart,
    changes::StartControllers,
    changes::Load>;

/// Applies any change; false if it cannot be.
bool apply(World& world, const Change& change);

}  // namespace playhouse::world
