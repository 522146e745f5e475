#pragma once

#include "playhouse/app/commands/options.h"

namespace playhouse::app {

/// `bench server`: serves a world of robots with lasers in real time; clients in
/// another process measure, over loopback TCP, request latency and data throughput
/// to 1, 20 and 200 of them. Prints one JSON line. Takes about fifteen seconds.
int bench_server(const BenchOptions& options);

}  // namespace playhouse::app
