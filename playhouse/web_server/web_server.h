#pragma once

/// WebServer: the page at http://bind:port/ and its viewers. Serves the built page from memory, sends every
/// viewer the scene and then changes only (replicate), and carries out what viewers ask for through
/// world::Control. Costs nothing while nobody watches. docs/viewer.md, docs/viewer-protocol.md. Threads:
/// wants_show() and show() are for the tick thread or one that works for it, all else for the thread of the
/// loop (the web thread) or for before it runs.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/replicate/scene_text.h"
#include "playhouse/web_server/guests.h"
#include "playhouse/web_server/page_files.h"
#include "playhouse/world/control.h"
#include "playhouse/world/physics_shapes.h"

namespace playhouse::web_server {

struct WebOptions {
  std::string bind = "127.0.0.1";  // numeric address
  std::uint16_t port = 8080;       // 0: any free one
  std::span<const PageFile> page;  // usually page_files()
  std::string host_name;           // of this machine; empty: the system is asked
  std::chrono::milliseconds viewer_quiet = std::chrono::seconds(limits::kViewerQuietSeconds);  // for tests
  std::vector<std::string> further_names;  // under which browsers may call us besides
  GuestBook guests;                        // who may come
  std::size_t viewers = limits::kViewers;  // at once, at most that
  /// What physics takes bodies for now; tick thread. None: nobody can tell.
  std::function<world::PhysicsShapes()> physics_shapes;
};

struct WebStatus {
  std::size_t viewers = 0;            // connected now
  std::uint64_t viewers_refused = 0;  // over the limit, with none that gave way
  std::uint64_t frames_sent = 0;
  std::uint64_t bytes_sent = 0;  // of frames
  std::uint64_t commands = 0;
  std::uint64_t commands_refused = 0;
};

class WebServer {
 public:
  /// Reads the world at once, so the first tick comes after; `devices` is asked now, and later by show() for
  /// models that come. The scene, the loop and the control outlive the server; destroy it when the loop no
  /// longer runs and show() is no longer called. A control that is still given changes (Control::post) may
  /// carry them out later: they touch only the world and the loop.
  WebServer(net::IoLoop& loop, WebOptions options, world::Control& control, const world::World& world,
            replicate::DeviceNames devices);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Opens the port and returns its number.
  Result<std::uint16_t> listen();

  /// Whether viewers are to be given the world's present state: somebody watches, and the last time was 33 ms
  /// of wall time ago. Ask after each tick, and while paused at least ten times a second, so that they see
  /// what was dragged and that the program lives. Costs an atomic load while nobody watches.
  bool wants_show() const;
  /// Gives it to them. The world stands still meanwhile.
  void show(const world::World& world, const world::Pace& pace);

  WebStatus status() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;  // with the tasks posted to the io loop, which may outlive the server
};

}  // namespace playhouse::web_server
