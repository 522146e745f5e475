#pragma once

/// The .cfg driver "laserrescan": the scans of a laser at other directions, by linear interpolation.

#include <optional>

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

struct LaserRescan {
  double min_angle = -geom::kPi / 2, max_angle = geom::kPi / 2;  // rad, of the first and the last beam
  int beams = 181;

  /// rad; between neighbouring beams.
  double step() const { return beams > 1 ? (max_angle - min_angle) / (beams - 1) : 0; }
  /// A direction beyond those of the scan has its maximum range, as nothing is known to be there. None of a scan
  /// whose angles are no numbers.
  std::optional<wire::laser::Data> scan(const wire::laser::Data& source) const;
  wire::laser::Config config(const wire::laser::Config& source) const;
};

Result<LaserRescan> laser_rescan_options(SectionFields fields);

extern const DriverDefinition kLaserRescanDriver;

}  // namespace playhouse::drivers
