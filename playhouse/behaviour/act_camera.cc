/// Cameras: pan, tilt and zoom towards the command, within limits of range and speed.

#include <algorithm>
#include <cmath>

#include "playhouse/behaviour/generated/acts.h"

namespace playhouse::behaviour {
namespace {

/// Motion of one axis within a tick.
struct Way {
  double limit;  // rad
  double dt;     // s

  /// Position control: moves towards a goal, and onto it if within reach. Returns the velocity. [rad/s]
  double towards(double goal, double& angle) const {
    const double before = angle, rest = goal - before;
    angle = std::fabs(rest) <= limit ? goal : before + std::copysign(limit, rest);
    return (angle - before) / dt;
  }
  /// Velocity control within limits; from outside them only inwards. Returns the velocity. [rad/s]
  double along(double velocity, double least, double most, double& angle) const {
    const double before = angle, wanted = before + std::clamp(velocity * dt, -limit, limit);
    angle = std::clamp(wanted, std::min(least, before), std::max(most, before));
    return (angle - before) / dt;
  }
};

/// Writes cameras' angles and rates. Cameras without users do not move.
class CameraAct final : public ActPhase {
 public:
  void act(world::World& world, world::Workers& workers) override {
    workers.run(world.cameras.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (const world::CameraRow row : world.cameras.rows().part(begin, end)) turn(world, row);
    });
  }

 private:
  static void turn(world::World& world, world::CameraRow row) {
    world::Cameras& cameras = world.cameras;
    const world::ModelRow model = cameras.model[row];
    cameras.pan_speed[row] = cameras.tilt_speed[row] = 0;
    if (!world::is_used(world, model)) return;
    const scene::CameraDesc& desc = *world.desc(model).camera;
    const double dt = world.scene().interval;
    const Way way{desc.pantilt_speed * dt, dt};
    if (cameras.mode[row] == world::ControlMode::kPosition) {
      cameras.pan_speed[row] = way.towards(cameras.goal_pan[row], cameras.pan[row]);
      cameras.tilt_speed[row] = way.towards(cameras.goal_tilt[row], cameras.tilt[row]);
    } else {
      cameras.pan_speed[row] =
          way.along(cameras.command_pan[row], desc.pan_min, desc.pan_max, cameras.pan[row]);
      cameras.tilt_speed[row] =
          way.along(cameras.command_tilt[row], desc.tilt_min, desc.tilt_max, cameras.tilt[row]);
    }
    way.towards(cameras.goal_zoom[row], cameras.zoom[row]);
  }
};

}  // namespace

std::unique_ptr<ActPhase> make_camera_act() {
  return std::make_unique<CameraAct>();
}

}  // namespace playhouse::behaviour
