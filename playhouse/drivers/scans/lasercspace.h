#pragma once

/// The .cfg driver "lasercspace": how far a round robot could drive in the direction of each beam of a laser.
///
/// In: a scan, and the robot's radius.
///
/// Out: the scan, each range shortened to where a disc about its end touches the end of a beam. What is beyond the end
/// of a beam is not known to be free, so that a beam without a hit bounds it, too.
///
/// Cost: the product of beams and the ends among them that count, 2 ns each.

#include <cstddef>
#include <optional>

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

struct LaserCSpace {
  static constexpr std::size_t kMostBeams = 8192;  // of a scan: what it costs is a square of them

  double radius = 0.5;  // m, of the robot
  int step = 1;         // every so many beams' ends count

  /// None of a scan with more beams, or whose angles are no numbers.
  std::optional<wire::laser::Data> scan(const wire::laser::Data& whole) const;
  wire::laser::Config config(const wire::laser::Config& whole) const { return whole; }
};

Result<LaserCSpace> laser_cspace_options(SectionFields fields);

extern const DriverDefinition kLaserCSpaceDriver;

}  // namespace playhouse::drivers
