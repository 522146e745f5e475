#pragma once

#include "playhouse/app/commands/options.h"

namespace playhouse::app {

/// `bench watched`: cost of viewers and clients to the tick. Robots with lasers run in real time, in
/// turn without viewers, with one page that shows the whole world and its measurements, and with 200
/// Player clients that read all lasers. Prints one JSON line: median CPU time of the tick thread per
/// tick, and ratios. Takes about a minute, or `--duration` seconds for each of the three.
int bench_watched(const BenchOptions& options);

}  // namespace playhouse::app
