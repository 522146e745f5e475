#pragma once

#include "playhouse/app/options.h"

namespace playhouse::app {

/// `bench server`: a world of robots with lasers runs in real time and is served; clients in a process of
/// their own measure, over loopback TCP, the round trip of a request, and how positions and lasers reach 1,
/// 20 and 200 of them. Prints one JSON line. Takes about fifteen seconds.
int bench_server(const BenchOptions& options);

}  // namespace playhouse::app
