#pragma once

#include "playhouse/app/options.h"

namespace playhouse::app {

/// `bench open`: two runs of the same world of robots with lasers, whose every device is open, in turn: one
/// encodes on the tick thread, the other on the engine's workers. Prints one JSON line.
int bench_open(const BenchOptions& options);

}  // namespace playhouse::app
