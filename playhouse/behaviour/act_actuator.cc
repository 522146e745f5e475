/// Actuators: converts commands to velocities along the axis, within limits of speed and position.

#include <algorithm>
#include <cmath>

#include "playhouse/behaviour/approach.h"
#include "playhouse/behaviour/generated/acts.h"

namespace playhouse::behaviour {
namespace {

constexpr double kNear = 1e-3;  // m or rad; a remaining distance covered in one tick, so that motion ends
constexpr double kRest = 1e-9;  // m or rad; treated as zero

double towards(double error, double limit, double dt) {
  if (std::fabs(error) > kNear) return approach(error, limit, dt);
  return std::clamp(error / dt, -limit, limit);
}

/// Limits the velocity so that no end stop is passed within a tick.
double before_the_ends(const scene::ActuatorDesc& desc, double position, double velocity, double dt) {
  if (velocity > 0) return std::min(velocity, std::max(0.0, (desc.max_position - position) / dt));
  return std::max(velocity, std::min(0.0, (desc.min_position - position) / dt));
}

double velocity_of(const world::World& world, world::ActuatorRow row) {
  const world::Actuators& actuators = world.actuators;
  const world::ModelRow model = actuators.model[row];
  const bool is_free = actuators.motor_on[row] && !actuators.braked[row];
  if (world.models.subscribers[model] == 0 || !is_free) return 0;
  const scene::ActuatorDesc& desc = *world.desc(model).actuator;
  const double dt = world.scene().interval, position = actuators.position[row];
  const double wanted =
      actuators.mode[row] == world::ControlMode::kPosition
          ? towards(actuators.goal[row] - position, std::clamp(actuators.speed[row], 0.0, desc.max_speed), dt)
          : std::clamp(actuators.command[row], -desc.max_speed, desc.max_speed);
  const bool is_limited = actuators.mode[row] == world::ControlMode::kPosition;
  const double gained =
      is_limited ? sped_up(actuators.velocity[row], wanted, actuators.acceleration[row], dt) : wanted;
  const double velocity = before_the_ends(desc, position, gained, dt);
  return std::fabs(velocity) * dt < kRest ? 0 : velocity;
}

/// Writes actuators.velocity. Without subscribers, braked, or without power they do not move.
class ActuatorAct final : public ActPhase {
 public:
  void act(world::World& world, world::Workers& workers) override {
    workers.run(world.actuators.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (const world::ActuatorRow row : world.actuators.rows().part(begin, end))
        world.actuators.velocity[row] = velocity_of(world, row);
    });
  }
};

}  // namespace

std::unique_ptr<ActPhase> make_actuator_act() {
  return std::make_unique<ActuatorAct>();
}

}  // namespace playhouse::behaviour
