#pragma once

/// The senses of the 2D engine; generated/senses.h lists them all.

#include "playhouse/behaviour/sense_phase.h"
#include "playhouse/stage/space.h"

namespace playhouse::stage {

using behaviour::SensorTable;
using SensePhase = behaviour::SensePhase<Space>;
using Senses = behaviour::Senses<Space>;

}  // namespace playhouse::stage
