#include "playhouse/app/bench_server.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "playhouse/app/bench_clients.h"
#include "playhouse/app/service.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"
#include "playhouse/scenarios/scenario.h"

namespace playhouse::app {
namespace {

constexpr std::uint32_t kRobots = 20;
constexpr int kRequests = 5000;
constexpr std::size_t kIdleClients = 4000;
constexpr double kFanOutSeconds = 3;

/// A one-way line between the two processes.
struct Pipe {
  int ends[2] = {-1, -1};
  bool open() { return pipe(ends) == 0; }
};

Result<std::string> measure(std::uint16_t port, std::size_t robots, pid_t server) {
  const Result<RoundTrip> round_trip = measure_round_trip(port, kRequests);
  if (!round_trip) return round_trip.error();
  const Result<RoundTrip> among_idle = measure_round_trip_among_idle(port, kRequests, kIdleClients);
  if (!among_idle) return among_idle.error();
  std::string line = fmt::format(
      R"("round_trip_p50_ms":{:.4f},"round_trip_p99_ms":{:.4f},"idle_clients":{},"among_idle_p50_ms":{:.4f},"among_idle_p99_ms":{:.4f},"fan_out":[)",
      round_trip->p50_ms, round_trip->p99_ms, kIdleClients, among_idle->p50_ms, among_idle->p99_ms);
  for (const std::size_t clients : {1u, 20u, 200u}) {
    const Result<FanOut> fan_out = measure_fan_out(
        {.port = port, .clients = clients, .robots = robots, .seconds = kFanOutSeconds, .server = server});
    if (!fan_out) return fan_out.error();
    line += fmt::format(R"({}{{"clients":{},"messages_per_s":{:.0f},"lost":{},"server_cpu":{:.3f}}})",
                        clients == 1 ? "" : ",", clients, fan_out->messages_per_s, fan_out->lost,
                        fan_out->cpu_share);
  }
  return line + "]";
}

/// The child process: waits for the port, measures, prints. The server ends when it does.
int be_clients(int port_from, std::size_t robots) {
  std::uint16_t port = 0;
  if (read(port_from, &port, sizeof(port)) != static_cast<ssize_t>(sizeof(port))) return kFailed;
  const Result<std::string> result = measure(port, robots, getppid());
  if (!result) {
    log::error("{}", result.error().line());
    return kFailed;
  }
  fmt::print(R"({{"scenario":"server","robots":{},{}}})"
             "\n",
             robots, *result);
  std::fflush(stdout);
  return kDone;
}

/// Serves until the clients' process ends.
int be_server(Service& service, int port_to, pid_t clients) {
  for (const auto step : {&Service::open_ports, &Service::make_devices}) {
    if (const Result<void> done = (service.*step)(); !done) {
      log::error("{}", done.error().line());
      return kFailed;
    }
  }
  const std::uint16_t port = service.player_ports().front();
  // The child's `port` end closes if we fail before this, which ends it.
  if (write(port_to, &port, sizeof(port)) != static_cast<ssize_t>(sizeof(port))) return kFailed;
  std::thread waiter([&] {
    siginfo_t end;
    waitid(P_PID, static_cast<id_t>(clients), &end, WEXITED | WNOWAIT);
    service.stop();
  });
  const Outcome outcome = service.run([&](int signal) {
    if (signal != 0) kill(clients, SIGKILL);  // what it measures from here on is false
  });
  waiter.join();
  int status = 0;
  waitpid(clients, &status, 0);
  if (outcome.signal != 0) return 128 + outcome.signal;
  return WIFEXITED(status) ? WEXITSTATUS(status) : kFailed;
}

}  // namespace

int bench_server(const BenchOptions& options) {
  const std::uint32_t robots = options.robots > 0 ? options.robots : kRobots;
  Result<scene::SceneDesc> scene = scenarios::make("laser", robots);
  if (!scene) {
    log::error("{}", scene.error().line());
    return kUsage;
  }
  Pipe port;
  if (!port.open()) return kFailed;
  // Before any thread: only then may a process be copied.
  const pid_t clients = fork();
  if (clients < 0) return kFailed;
  if (clients == 0) {
    close(port.ends[1]);
    const int code = be_clients(port.ends[0], robots);
    log::flush();
    std::_Exit(code);
  }
  close(port.ends[0]);
  Service service({.port = 0, .web = std::nullopt},
                  {.speed = 1, .duration = {}, .seed = options.seed, .workers = options.workers},
                  QuitTime::kIgnored);
  service.take_scene(std::move(*scene));
  const int code = be_server(service, port.ends[1], clients);
  close(port.ends[1]);
  return code;
}

}  // namespace playhouse::app
