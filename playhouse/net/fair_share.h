#pragma once

/// Eviction policy when every place of a server is taken: the longest idle connection of the network that
/// holds the most. So a network can take places from itself, and never the last
/// ones of others.

#include <chrono>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace playhouse::net {

struct Holder {
  std::string_view network;
  std::chrono::steady_clock::time_point quiet_since;
};

/// "10.0.0.7" of "10.0.0.7:4242". Of an IPv6 address the /64 prefix, which one user typically owns.
std::string network_of(std::string_view peer);

/// Whether "127.0.0.1:4242" is a peer on this machine.
bool is_local(std::string_view peer);

std::size_t places_of(std::span<const Holder> holders, std::string_view network);

/// The place among `holders`, of which there is at least one, of the one that gives way.
std::size_t gives_way(std::span<const Holder> holders);

}  // namespace playhouse::net
