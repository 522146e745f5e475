#include "playhouse/app/benches/bench_server.h"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

#include "playhouse/app/benches/bench_apart.h"
#include "playhouse/app/benches/bench_clients.h"
#include "playhouse/base/fail.h"
#include "playhouse/scenarios/scenario.h"

namespace playhouse::app {
namespace {

constexpr std::uint32_t kRobots = 20;
constexpr int kRequests = 5000;
constexpr std::size_t kIdleClients = 10000;
constexpr std::size_t kReaders = 200;
constexpr double kFanOutSeconds = 3;

Result<std::string> measure(std::uint16_t port, std::size_t robots, pid_t server) {
  const Result<RoundTrip> round_trip = measure_round_trip(port, kRequests);
  if (!round_trip) return round_trip.error();
  const Result<AmongIdle> among_idle = measure_round_trip_among_idle(port, kRequests, kIdleClients, server);
  if (!among_idle) return among_idle.error();
  const FanOutPlan readers{
      .port = port, .clients = kReaders, .robots = robots, .seconds = 0, .server = server};
  const Result<RoundTrip> among_readers = measure_round_trip_among_readers(readers, kRequests);
  if (!among_readers) return among_readers.error();
  std::string line = fmt::format(
      R"("round_trip_p50_ms":{:.4f},"round_trip_p99_ms":{:.4f},"idle_clients":{},"among_idle_p50_ms":{:.4f},"among_idle_p99_ms":{:.4f},"idle_client_bytes":{:.0f},"readers":{},"among_readers_p50_ms":{:.4f},"among_readers_p99_ms":{:.4f},"fan_out":[)",
      round_trip->p50_ms, round_trip->p99_ms, kIdleClients, among_idle->round_trip.p50_ms,
      among_idle->round_trip.p99_ms, among_idle->bytes_of_each, kReaders, among_readers->p50_ms,
      among_readers->p99_ms);
  for (const std::size_t clients : {1u, 20u, 200u, 1000u}) {
    const Result<FanOut> fan_out = measure_fan_out(
        {.port = port, .clients = clients, .robots = robots, .seconds = kFanOutSeconds, .server = server});
    if (!fan_out) return fan_out.error();
    line += fmt::format(R"({}{{"clients":{},"messages_per_s":{:.0f},"lost":{},"server_cpu":{:.3f}}})",
                        clients == 1 ? "" : ",", clients, fan_out->messages_per_s, fan_out->lost,
                        fan_out->cpu_share);
  }
  return line + "]";
}

int print_measured(std::uint16_t port, std::size_t robots, pid_t server) {
  const Result<std::string> result = measure(port, robots, server);
  if (!result) return fail(result.error());
  fmt::print(R"({{"scenario":"server","robots":{},{}}})"
             "\n",
             robots, *result);
  std::fflush(stdout);
  return kDone;
}

}  // namespace

int bench_server(const BenchOptions& options) {
  const std::uint32_t robots = options.robots > 0 ? options.robots : kRobots;
  Result<scene::SceneDesc> scene = scenarios::make("laser", robots);
  if (!scene) return fail(scene.error(), kUsage);
  return serve_apart(options, std::move(*scene), [robots](const Ports& ports, pid_t server) {
    return print_measured(ports.player, robots, server);
  });
}

}  // namespace playhouse::app
