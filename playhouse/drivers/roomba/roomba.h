#pragma once

/// The .cfg driver "roomba": iRobot's Roomba, by its serial port (irobot/oi_robot.h).

#include "playhouse/drivers/definition.h"

namespace playhouse::drivers {

extern const DriverDefinition kRoombaDriver;

}  // namespace playhouse::drivers
