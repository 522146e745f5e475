#include "playhouse/drivers/create/create.h"

#include "playhouse/drivers/irobot/oi_robot.h"

namespace playhouse::drivers {
namespace {

OiRobotOptions create_options(SectionFields& fields) {
  OiRobotOptions options{.hardware = {}, .generation = irobot::RobotGeneration::kCreate};
  read_oi_options(fields, options);
  return options;
}

}  // namespace

constinit const DriverDefinition kCreateDriver{
    .name = "create",
    .doc = "iRobot's Create, by its serial port.",
    .provides = kOiProvides,
    .read_options = reading<create_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_hardware<OiRobot>(section, site, create_options, kOiProvides);
    },
};

}  // namespace playhouse::drivers
