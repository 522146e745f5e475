#pragma once

/// What tests of the client have in common: scripts of a server, and how they connect to it.

#include <functional>
#include <utility>

#include "fake_server.h"
#include "playhouse/base/assert.h"
#include "playhouse_client/client.h"
#include "playhouse_client/position2d.h"

namespace playhouse::client {

/// Too short for an answer to come. [s]
inline constexpr Seconds kShort{0.02};

inline FakeServer::Script rounds(std::function<void(Peer&, const Received&)> rest) {
  return [rest](Peer& peer) { peer.serve([&](const Received& message) { rest(peer, message); }); };
}

inline FakeServer::Script silent() {
  return rounds([](Peer&, const Received&) {});
}

inline Client connect(const FakeServer& server, const Options& options = {}) {
  Result<Client> client = Client::connect(server.address(), options);
  PLAYHOUSE_ASSERT(client.ok());
  return std::move(*client);
}

inline Position2d open_robot(Client& client) {
  Result<Position2d> robot = Position2d::open(client, 0);
  PLAYHOUSE_ASSERT(robot.ok());
  return std::move(*robot);
}

}  // namespace playhouse::client
