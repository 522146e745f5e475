#pragma once

/// WebServer: the page at http://bind:port/ and its viewers. Serves the page from memory,
/// sends every viewer the scene and then deltas (replicate), and executes viewers' commands
/// through world::Control. No cost without viewers. docs/viewer.md, docs/viewer-protocol.md.
/// Thread: io (the web thread), or before that runs.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/net/forwarded.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/network.h"
#include "playhouse/replicate/snapshot_feed.h"
#include "playhouse/server/guests/guest_book.h"
#include "playhouse/web_server/bodies.h"
#include "playhouse/web_server/page_files.h"
#include "playhouse/web_server/player_path.h"
#include "playhouse/world/control.h"
#include "playhouse/world/physics_shapes.h"
#include "playhouse/world/population/shares.h"

namespace playhouse::web_server {

struct WebOptions {
  std::string bind = "127.0.0.1";                     // numeric address
  std::uint16_t port = 8080;                          // 0: any free one
  std::span<const PageFile> page;                     // usually page_files()
  std::string host_name;                              // of this machine; empty: ask the system
  double viewer_quiet = limits::kViewerQuietSeconds;  // s; for tests
  double join_period = 1;                             // s between two bodies; for tests
  std::vector<std::string> further_names;             // further allowed host names
  server::GuestBook guests;                           // access list
  net::TrustedProxies proxies;                        // in front of the page, which name its clients
  std::function<void()> sent_out;          // called after somebody was sent out, on the io thread; or empty
  std::size_t viewers = limits::kViewers;  // limit on simultaneous viewers
  std::uint32_t bytes_per_second = limits::kPageBytesPerSecond;  // of state, to each page
  /// Current collision shapes; tick thread. Empty: not available.
  std::function<world::PhysicsShapes()> physics_shapes;
  /// Where a person who joins goes; tick thread. Empty: anywhere.
  PlaceOfBody place_of_body;
  /// Player clients by WebSocket, on the loop of their server, which ends before this page; none: no clients.
  struct PlayerClients {
    net::IoLoop* loop = nullptr;
    std::uint16_t port = 0;  // of clients that name none
    ClientCame came;         // on the loop's thread
  };
  std::optional<PlayerClients> player_clients = {};
  /// What each page and client brought; tick thread.
  std::shared_ptr<world::Shares> shares = std::make_shared<world::Shares>();
};

struct WebStatus {
  std::size_t viewers = 0;            // connected now
  std::uint64_t viewers_refused = 0;  // at the limit, with no idle viewer to replace
  std::uint64_t frames_sent = 0;
  std::uint64_t bytes_sent = 0;  // of frames
  std::uint64_t commands = 0;
  std::uint64_t commands_refused = 0;
};

class WebServer {
 public:
  /// Reads the world at once, so construct it before the first tick. The scene, the network, the control and
  /// the feed, of the same world, must outlive the server; destroy it when the network has stopped and the feed
  /// is no longer shown. Changes queued in the control may run later: they touch only the world and the network.
  WebServer(net::Network& network, WebOptions options, world::Control& control, const world::World& world,
            replicate::SnapshotFeed& feed);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Starts listening; returns the port.
  Result<std::uint16_t> listen();

  WebStatus status() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;  // shared with tasks posted to the io loop, which may outlive the server
};

}  // namespace playhouse::web_server
