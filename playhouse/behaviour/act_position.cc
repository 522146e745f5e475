/// Drive models: converts a robot's command to a velocity in its own frame, within its bounds.

#include <algorithm>
#include <cmath>

#include "playhouse/behaviour/approach.h"
#include "playhouse/behaviour/generated/acts.h"

namespace playhouse::behaviour {
namespace {

using geom::Pose;
using geom::Twist;
using geom::Vec2;
using scene::Drive;

// Gains of Stage's position control: speed is proportional to the error, up to these limits.
constexpr double kSpeed = 0.4;               // m/s
constexpr double kTurn = 1.0;                // rad/s
constexpr double kArrived = 0.02;            // m, per axis
constexpr double kFacing = geom::kPi / 16;   // rad; a diff robot drives once its heading error is below
constexpr double kCarArrived = 0.05;         // m
constexpr double kSteering = geom::kPi / 4;  // rad; limit of steering on the way to a goal

/// True for holonomic drives.
bool is_free(const scene::PositionDesc& desc) {
  return desc.drive == Drive::kOmni || desc.drive == Drive::kWalk;
}

Twist car(double speed, double steering, double wheelbase) {
  const geom::SinCos sc = geom::sincos(steering);
  return {speed * sc.cos, 0, 0, wheelbase > 0 ? speed * sc.sin / wheelbase : 0};
}

Twist follow_velocity(const scene::PositionDesc& desc, const Twist& command) {
  switch (desc.drive) {
    case Drive::kDiff:
      return {command.x, 0, 0, command.a};
    case Drive::kOmni:
    case Drive::kWalk:
      return {command.x, command.y, 0, command.a};
    case Drive::kCar:
      return car(command.x, geom::normalize(command.a), desc.wheelbase);
  }
  return {};
}

/// Speeds on the way to a goal.
struct Pace {
  double speed = kSpeed;  // m/s
  double turn = kTurn;    // rad/s
};

Twist diff_to_goal(Vec2 error_O, double distance, const Pose& X_OM, const Pose& goal, Pace pace, double dt) {
  if (std::fabs(error_O.x) < kArrived && std::fabs(error_O.y) < kArrived)
    return {0, 0, 0, approach(geom::normalize(goal.a - X_OM.a), pace.turn, dt)};
  const double angle = geom::normalize(geom::atan2(error_O.y, error_O.x) - X_OM.a);
  const double ahead = std::fabs(angle) < kFacing ? approach(distance, pace.speed, dt) : 0;
  return {ahead, 0, 0, approach(angle, pace.turn, dt)};
}

Twist omni_to_goal(Vec2 error_M, const Pose& X_OM, const Pose& goal, Pace pace, double dt) {
  return {approach(error_M.x, pace.speed, dt), approach(error_M.y, pace.speed, dt), 0,
          approach(geom::normalize(goal.a - X_OM.a), pace.turn, dt)};
}

/// Pure pursuit: the circle through the car, tangent to its
/// heading, through the goal; in reverse if that is behind.
Twist car_to_goal(Vec2 error_M, double distance, double wheelbase, Pace pace, double dt) {
  if (distance < kCarArrived) return {};
  const double curvature = 2 * error_M.y / (distance * distance);
  const double steering = std::clamp(geom::atan2(curvature * wheelbase, 1.0), -kSteering, kSteering);
  const double speed = approach(distance, pace.speed, dt);
  return car(error_M.x < 0 ? -speed : speed, steering, wheelbase);
}

Twist follow_goal(const scene::PositionDesc& desc, const Pose& X_OM, const Pose& goal, Pace pace, double dt) {
  const Vec2 error_O = goal.xy() - X_OM.xy();
  const double distance = std::sqrt(geom::dot(error_O, error_O));
  if (desc.drive == Drive::kDiff) return diff_to_goal(error_O, distance, X_OM, goal, pace, dt);
  const Vec2 error_M = geom::Rotation::of(X_OM.a).inverse(error_O);
  if (is_free(desc)) return omni_to_goal(error_M, X_OM, goal, pace, dt);
  return car_to_goal(error_M, distance, desc.wheelbase, pace, dt);
}

Twist accelerate(const scene::PositionDesc& desc, const Twist& velocity, const Twist& command, double dt) {
  const scene::Interval* bounds = desc.acceleration_bounds;
  const bool omni = is_free(desc);
  return {velocity.x + dt * std::clamp(command.x, bounds[0].min, bounds[0].max),
          omni ? velocity.y + dt * std::clamp(command.y, bounds[1].min, bounds[1].max) : 0, 0,
          velocity.a + dt * std::clamp(command.a, bounds[3].min, bounds[3].max)};
}

/// Steering is limited as on the way to a goal, and reversed when driving backwards.
Twist follow_heading(const scene::PositionDesc& desc, const Twist& command, double heading_O, double dt) {
  const double error = geom::normalize(command.a - heading_O);
  if (desc.drive == Drive::kCar) {
    const double steering = std::clamp(error, -kSteering, kSteering);
    return car(command.x, command.x < 0 ? -steering : steering, desc.wheelbase);
  }
  return {command.x, 0, 0, approach(error, kTurn, dt)};
}

Twist within(const scene::Interval* bounds, const Twist& velocity) {
  return {std::clamp(velocity.x, bounds[0].min, bounds[0].max),
          std::clamp(velocity.y, bounds[1].min, bounds[1].max), 0,
          std::clamp(velocity.a, bounds[3].min, bounds[3].max)};
}

Pace pace_of(const world::Positions& positions, world::PositionRow robot) {
  const Twist& limit = positions.speed_limit[robot];
  return {limit.x > 0 ? limit.x : kSpeed, limit.a > 0 ? limit.a : kTurn};
}

Twist limited(const world::Positions& positions, world::PositionRow robot, const Twist& wanted, double dt) {
  const Twist &limit = positions.acceleration_limit[robot], &before = positions.velocity[robot];
  return {sped_up(before.x, wanted.x, limit.x, dt), sped_up(before.y, wanted.y, limit.x, dt), wanted.z,
          sped_up(before.a, wanted.a, limit.a, dt)};
}

Twist velocity_of(const world::World& world, world::PositionRow robot) {
  const world::Positions& positions = world.positions;
  const world::ModelRow model = positions.model[robot];
  if (world.models.subscribers[model] == 0 || !positions.motor_on[robot]) return {};
  const scene::PositionDesc& desc = *world.desc(model).position;
  const double dt = world.scene().interval;
  Twist wanted;
  switch (positions.mode[robot]) {
    case world::ControlMode::kVelocity:
      wanted = follow_velocity(desc, positions.command[robot]);
      break;
    case world::ControlMode::kPosition:
      wanted = follow_goal(desc, positions.X_OM[robot], positions.goal[robot], pace_of(positions, robot), dt);
      wanted = limited(positions, robot, wanted, dt);
      break;
    case world::ControlMode::kAcceleration:
      wanted = accelerate(desc, positions.velocity[robot], positions.command[robot], dt);
      break;
    case world::ControlMode::kHeading:
      wanted = follow_heading(desc, positions.command[robot], positions.X_OM[robot].a, dt);
      break;
  }
  return within(desc.velocity_bounds, wanted);
}

/// Writes positions.velocity. Robots without subscribers or with motors off do not move.
class PositionAct final : public ActPhase {
 public:
  void act(world::World& world, world::Workers& workers) override {
    workers.run(world.positions.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (const world::PositionRow robot : world.positions.rows().part(begin, end))
        world.positions.velocity[robot] = velocity_of(world, robot);
    });
  }
};

}  // namespace

std::unique_ptr<ActPhase> make_position_act() {
  return std::make_unique<PositionAct>();
}

}  // namespace playhouse::behaviour
