#pragma once

/// The senses of the 2D engine; generated/senses.h lists them all.

#include "playhouse/behaviour/sense_phase.h"
#include "playhouse/bodies/space.h"

namespace playhouse::senses {

using behaviour::SensorTable;
using SensePhase = behaviour::SensePhaseOf<bodies::Space>;
using Senses = behaviour::SensesOf<bodies::Space>;

}  // namespace playhouse::senses
