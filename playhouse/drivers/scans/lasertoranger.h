#pragma once

/// The .cfg driver "lasertoranger": a laser as a ranger of one element, for programs that know rangers alone.

#include <optional>
#include <string_view>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/scans/to_ranger.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

struct LaserSource {
  static constexpr std::string_view kInterface = "laser";

  static std::optional<RangerReading> reading(const device::Publication& message);
  static void answer(Shell& shell);
};

/// The laser is the ranger's only element, and where the ranger is.
wire::ranger::Geom ranger_geom_of(const wire::laser::Geom& laser);
/// A laser does not tell its minimum range: 0.
wire::ranger::Config ranger_config_of(const wire::laser::Config& laser);

extern const DriverDefinition kLaserToRangerDriver;

}  // namespace playhouse::drivers
