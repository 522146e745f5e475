#pragma once

#include "playhouse/app/options.h"

namespace playhouse::app {

/// `bench load`: a world file of robots that are alike, each a line with a name and a pose of its own and
/// with twelve rangers of one beam as parts, becomes an engine that is ready for its first tick. Prints one
/// JSON line: the times of the file and of the engine, and the largest memory that the program had meanwhile.
int bench_load(const BenchOptions& options);

}  // namespace playhouse::app
