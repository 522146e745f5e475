#include "playhouse/app/benches/bench_apart.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <thread>
#include <utility>

#include "playhouse/base/fail.h"
#include "playhouse/base/log_output.h"

namespace playhouse::app {
namespace {

/// A one-way pipe between the two processes.
struct Pipe {
  int ends[2] = {-1, -1};
  bool open() { return pipe(ends) == 0; }
};

/// Main of the child process: waits for the ports.
int be_clients(int ports_from, const Clients& clients) {
  Ports ports;
  if (read(ports_from, &ports, sizeof(ports)) != static_cast<ssize_t>(sizeof(ports))) return kFailed;
  return clients(ports, getppid());
}

/// Serves until the client process exits.
int be_server(Service& service, int ports_to, pid_t clients, const std::function<void(Service&)>& ready) {
  for (const auto step : {&Service::open_ports, &Service::make_devices, &Service::open_page}) {
    if (const Result<void> done = (service.*step)(); !done) return fail(done.error());
  }
  if (ready) ready(service);
  const Ports ports{service.player_ports().front(), service.web_port()};
  // If we fail before this, the pipe closes, which ends the child.
  if (write(ports_to, &ports, sizeof(ports)) != static_cast<ssize_t>(sizeof(ports))) return kFailed;
  std::thread waiter([&] {
    siginfo_t end;
    waitid(P_PID, static_cast<id_t>(clients), &end, WEXITED | WNOWAIT);
    service.stop();
  });
  const Outcome outcome = service.run([&](int signal) {
    if (signal != 0) kill(clients, SIGKILL);  // its further measurements are invalid
  });
  waiter.join();
  int status = 0;
  waitpid(clients, &status, 0);
  if (outcome.signal != 0) return 128 + outcome.signal;
  return WIFEXITED(status) ? WEXITSTATUS(status) : kFailed;
}

}  // namespace

int serve_apart(const BenchOptions& options, scene::SceneDesc scene, const Clients& clients,
                const std::function<void(Service&)>& ready) {
  Pipe ports;
  if (!ports.open()) return kFailed;
  // Before any thread exists: fork() is safe only then.
  const pid_t child = fork();
  if (child < 0) return kFailed;
  if (child == 0) {
    close(ports.ends[1]);
    const int code = be_clients(ports.ends[0], clients);
    log::flush();
    std::_Exit(code);
  }
  close(ports.ends[0]);
  Service service({.port = 0, .web = 0},
                  {.speed = 1, .duration = {}, .seed = options.seed, .workers = options.workers},
                  QuitTime::kIgnored);
  service.take_scene(std::move(scene));
  const int code = be_server(service, ports.ends[1], child, ready);
  close(ports.ends[1]);
  return code;
}

}  // namespace playhouse::app
