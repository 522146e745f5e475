#pragma once

/// Eviction policy when a server is full: the longest idle connection
/// of the network with the most connections. So a network can evict
/// only itself, and never takes the last connections of others.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace playhouse::net {

struct Holder {
  std::string_view network;
  double quiet_since = 0;  // s, of any clock
};

/// "10.0.0.7" of "10.0.0.7:4242". For IPv6 the /64 prefix, typically one user's.
std::string network_of(std::string_view peer);

/// True if the peer is of this machine: "127.0.0.1:4242", or by a Unix socket
/// "unix:PROCESS" or "/FOLDER:6665".
bool is_local(std::string_view peer);

/// Whom a peer's share of a run belongs to: its token, without one ("*") its network. Of loopback peers
/// without one each is somebody else, as anybody may be behind them.
std::string holder_of(std::string_view token, std::string_view peer);

std::size_t places_of(std::span<const Holder> holders, std::string_view network);

/// Index in `holders`, non-empty, of the connection to evict.
std::size_t gives_way(std::span<const Holder> holders);

}  // namespace playhouse::net
