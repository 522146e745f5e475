#pragma once

#include "playhouse/app/commands/options.h"

namespace playhouse::app {

/// `bench load`: loads a world file of equal robots, each a line with name and pose,
/// with twelve single-beam rangers as parts, up to an engine ready for its first tick.
/// Prints one JSON line: times of loading and of making the engine, and peak memory.
int bench_load(const BenchOptions& options);

}  // namespace playhouse::app
