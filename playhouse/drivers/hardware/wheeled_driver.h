#pragma once

/// WheeledDriver: what drivers of bases with wheels have in common: a velocity that is a number, and stops when nobody commands
/// any more; motors; the pose that clients set.

#include <cstddef>
#include <string>

#include "playhouse/drivers/hardware/hardware_driver.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

class WheeledDriver : public HardwareDriver {
 protected:
  /// `wheels`: number of the position2d among the devices that it offers.
  WheeledDriver(std::string name, Site& site, HardwareOptions options, std::size_t wheels);

  /// Forward and turning, within 1,000 m/s and rad/s, so that nothing overflows on the way to the limits of the wheels.
  virtual void drive(const geom::Twist& wanted) = 0;
  /// Without motors of its own to switch off it stands while they are off.
  virtual AnswerBody set_motors(bool on);
  virtual wire::position2d::Geom geometry() const = 0;
  /// Where the robot is now has this pose from now on.
  virtual void set_pose(const geom::Pose& X_OR) = 0;
  void stop_wheels() override { drive({}); }

 private:
  void take(const wire::Pose2d& velocity);

  bool motors_on_ = true;
};

}  // namespace playhouse::drivers
