#pragma once

/// The .cfg driver "sonartoranger": sonars as a ranger with an element each, for programs that know rangers alone.

#include <optional>
#include <string_view>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/scans/to_ranger.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {

struct SonarSource {
  static constexpr std::string_view kInterface = "sonar";

  static std::optional<RangerReading> reading(const device::Publication& message);
  static void answer(Shell& shell);
};

/// The ranger is where the robot is; a sonar does not tell its size: 0.
wire::ranger::Geom ranger_geom_of(const wire::sonar::Geom& sonars);

extern const DriverDefinition kSonarToRangerDriver;

}  // namespace playhouse::drivers
