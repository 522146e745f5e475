#pragma once

/// A server and its clients in separate processes, so that their resources are measured separately.

#include <functional>

#include "playhouse/app/commands/options.h"
#include "playhouse/app/service.h"

namespace playhouse::app {

/// Ports of a server on the loopback address.
struct Ports {
  std::uint16_t player = 0, web = 0;
};
/// Body of the clients' process; returns its exit code.
using Clients = std::function<int(const Ports& ports, pid_t server)>;

/// Serves a scene in real time until `clients` has returned in a child process; returns its exit code. Must
/// be called before any thread exists. `ready` is called when all ports are open, before the run begins.
int serve_apart(const BenchOptions& options, scene::SceneDesc scene, const Clients& clients,
                const std::function<void(Service&)>& ready = {});

}  // namespace playhouse::app
