#pragma once

#include "playhouse/app/options.h"

namespace playhouse::app {

/// `bench open`: two runs of the same world of robots with lasers, whose every device is open, in turn: in
/// one the tick thread and the publisher thread encode, in the other the engine's workers help. Prints one
/// JSON line.
int bench_open(const BenchOptions& options);

}  // namespace playhouse::app
