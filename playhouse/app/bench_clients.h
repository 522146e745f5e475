#pragma once

/// The clients' side of `bench server`: talks to a server over TCP and measures. Knows nothing of the
/// server's inside.

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::app {

/// Times of a request for geometry and its answer.
struct RoundTrip {
  double p50_ms = 0, p99_ms = 0;
};
Result<RoundTrip> measure_round_trip(std::uint16_t port, int requests);
/// The same while so many others are connected and say nothing.
Result<RoundTrip> measure_round_trip_among_idle(std::uint16_t port, int requests, std::size_t idle);

/// How data reached `clients` connections, each with a position2d and a laser of robot (client modulo robots)
/// open.
struct FanOut {
  std::size_t clients = 0;
  double messages_per_s = 0;
  std::uint64_t lost = 0;  // gaps in the timestamps, which come every `interval`
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

/// Watches all of a world and what its sensors measure as a page does, whose port that is, for so long;
/// `watches` hears when that begins and ends. Gives the packets per second.
Result<double> watch_as_page(std::uint16_t port, double seconds, const std::function<void(bool)>& watches);
/// Reads the lasers of all robots, each with one of the clients; `reads` hears when all are open, and of the
/// end.
Result<FanOut> read_lasers(const FanOutPlan& plan, const std::function<void(bool)>& reads);

}  // namespace playhouse::app
