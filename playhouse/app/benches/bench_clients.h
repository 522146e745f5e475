#pragma once

/// Client side of `bench server`: measures
/// a server over TCP, as a black box.

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::app {

/// Latency of a geometry request.
struct RoundTrip {
  double p50_ms = 0, p99_ms = 0;
};
Result<RoundTrip> measure_round_trip(std::uint16_t port, int requests);
/// The same with so many further idle connections, and what each of these takes of the server's memory.
struct AmongIdle {
  RoundTrip round_trip;
  double bytes_of_each = 0;
};
Result<AmongIdle> measure_round_trip_among_idle(std::uint16_t port, int requests, std::size_t idle,
                                                pid_t server);

/// Throughput of data to `clients` connections, each with a
/// position2d and a laser of robot (client modulo robots) open.
struct FanOut {
  std::size_t clients = 0;
  double messages_per_s = 0;
  std::uint64_t lost = 0;  // detected by gaps in timestamps
  double cpu_share = 0;    // of one core, used by process `server`
};
struct FanOutPlan {
  std::uint16_t port = 0;
  std::size_t clients = 1, robots = 1;
  double interval = 0.1;  // s, between data
  double seconds = 3;
  pid_t server = 0;
};
Result<FanOut> measure_fan_out(const FanOutPlan& plan);
/// Latency of a geometry request while the plan's connections read.
Result<RoundTrip> measure_round_trip_among_readers(const FanOutPlan& plan, int requests);

/// Views a whole world with its measurements through the page's protocol, for so
/// long; `watches` is called at the start and at the end. Returns packets per second.
Result<double> watch_as_page(std::uint16_t port, double seconds, const std::function<void(bool)>& watches);
/// Reads the lasers of all robots, one by each client;
/// `reads` is called when all are open, and at the end.
Result<FanOut> read_lasers(const FanOutPlan& plan, const std::function<void(bool)>& reads);

}  // namespace playhouse::app
