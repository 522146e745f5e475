#include "playhouse/drivers/roomba/roomba.h"

#include "playhouse/drivers/irobot/oi_robot.h"

namespace playhouse::drivers {
namespace {

OiRobotOptions roomba_options(SectionFields& fields) {
  OiRobotOptions options;
  if (fields.flag(
          {"roomba500", "1: a robot of the 500 series or later, which speaks at 115200 baud, not 57600."},
          false))
    options.generation = irobot::RobotGeneration::k500;
  read_oi_options(fields, options);
  return options;
}

}  // namespace

constinit const DriverDefinition kRoombaDriver{
    .name = "roomba",
    .doc = "iRobot's Roomba, by its serial port.",
    .provides = kOiProvides,
    .read_options = reading<roomba_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_hardware<OiRobot>(section, site, roomba_options, kOiProvides);
    },
};

}  // namespace playhouse::drivers
