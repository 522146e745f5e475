#pragma once

/// Base of position2d and position3d: what clients may set of a robot's control. A simulated drive has the velocity
/// that it is told, so that gains are kept and have no effect.

#include <cmath>
#include <utility>

#include "playhouse/bridge/settings/settings.h"

namespace playhouse::drivers {

struct DriveSettings {
  double speed_kp = 0, speed_ki = 0, speed_kd = 0;
  double position_kp = 0, position_ki = 0, position_kd = 0;
};

class DriveDevice : public DeviceWithSettings<DriveSettings> {
 public:
  DriveDevice(run::Simulation& simulation, world::ModelRow model)
      : DeviceWithSettings(simulation, simulation.world().id(model), DriveSettings{}) {}

  world::ModelId robot() const override { return model(); }
  /// What was set of the way to a goal ends with the last client of either device.
  void closed(world::Journal& journal) override;

 protected:
  /// SPEED_PROF: limits of the motion, as position2d has it, or of the turn, as position3d.
  void limit_way(float speed, float acceleration, double geom::Twist::*part, device::Replier replier) const;

  /// SPEED_PID, or POSITION_PID: the interfaces have structs of their own, of the same fields.
  template <typename Request>
  void set_gains(const device::Message& message, bool of_speed, device::Replier replier) {
    const auto value = wire::decode<Request>(message.body);
    if (!value) return;
    change_settings(std::move(replier), [of_speed, value = *value](DriveSettings& wanted) {
      (of_speed ? wanted.speed_kp : wanted.position_kp) = static_cast<double>(value.kp);
      (of_speed ? wanted.speed_ki : wanted.position_ki) = static_cast<double>(value.ki);
      (of_speed ? wanted.speed_kd : wanted.position_kd) = static_cast<double>(value.kd);
      return true;
    });
  }

 private:
  std::span<const NamedSetting> named() const override {
    static constexpr NamedSetting kNamed[] = {
        {"speed_pid.kp", &DriveSettings::speed_kp},       {"speed_pid.ki", &DriveSettings::speed_ki},
        {"speed_pid.kd", &DriveSettings::speed_kd},       {"position_pid.kp", &DriveSettings::position_kp},
        {"position_pid.ki", &DriveSettings::position_ki}, {"position_pid.kd", &DriveSettings::position_kd},
    };
    return kNamed;
  }
  bool settle(DriveSettings& wanted) const override {
    return std::isfinite(wanted.speed_kp) && std::isfinite(wanted.speed_ki) &&
           std::isfinite(wanted.speed_kd) && std::isfinite(wanted.position_kp) &&
           std::isfinite(wanted.position_ki) && std::isfinite(wanted.position_kd);
  }
};

}  // namespace playhouse::drivers
