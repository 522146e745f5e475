#pragma once

#include "playhouse/app/commands/options.h"

namespace playhouse::app {

/// `bench open`: two alternating runs of a world of robots with lasers,
/// with all devices open: in one the tick and publisher threads encode,
/// in the other also the engine's workers. Prints one JSON line.
int bench_open(const BenchOptions& options);

}  // namespace playhouse::app
