#pragma once

/// The .cfg driver "lasercutter": the beams of a laser within a window of directions.

#include <optional>

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

struct LaserCutter {
  double min_angle = -geom::kPi / 2, max_angle = geom::kPi / 2;  // rad, of the window

  /// None of a scan whose angles are no numbers. Its angles are those of the beams that are left.
  std::optional<wire::laser::Data> scan(const wire::laser::Data& whole) const;
  wire::laser::Config config(const wire::laser::Config& whole) const;
};

Result<LaserCutter> laser_cutter_options(SectionFields fields);

extern const DriverDefinition kLaserCutterDriver;

}  // namespace playhouse::drivers
