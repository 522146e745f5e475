#pragma once

#include "playhouse/app/options.h"

namespace playhouse::app {

/// `bench watched`: what those who watch cost the tick. Robots with lasers run in real time; in turn nobody
/// watches, a page shows all of the world with what sensors measure, and 200 Player clients read all lasers.
/// Prints one JSON line: processor time of the tick thread in a tick, medians, and their ratios. Takes about
/// a minute, or less with `--duration`: seconds of each of the three.
int bench_watched(const BenchOptions& options);

}  // namespace playhouse::app
