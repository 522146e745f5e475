#pragma once

/// A server and its clients in a process of their own, so that what one takes is not the other's.

#include <functional>

#include "playhouse/app/options.h"
#include "playhouse/app/service.h"

namespace playhouse::app {

/// Of a server, on the loopback address.
struct Ports {
  std::uint16_t player = 0, web = 0;
};
/// What the clients' process does; gives its exit code.
using Clients = std::function<int(const Ports& ports, pid_t server)>;

/// Serves a scene in real time until `clients` has returned in a process of its own; gives its exit code. To
/// be called before there is any thread. `ready` is called once everything is open, before the run begins.
int serve_apart(const BenchOptions& options, scene::SceneDesc scene, const Clients& clients,
                const std::function<void(Service&)>& ready = {});

}  // namespace playhouse::app
