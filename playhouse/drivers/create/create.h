#pragma once

/// The .cfg driver "create": iRobot's Create, by its serial port (irobot/oi_robot.h).

#include "playhouse/drivers/definition.h"

namespace playhouse::drivers {

extern const DriverDefinition kCreateDriver;

}  // namespace playhouse::drivers
