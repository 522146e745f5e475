#pragma once

/// Who gives way when every place of a server is taken: of the network that holds the most places, the holder
/// that has been quiet for the longest time. So a network can take places from itself, and never the last
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

/// "10.0.0.7" of "10.0.0.7:4242". Of an IPv6 address the first 64 bits: everybody has all that begin with
/// theirs.
std::string network_of(std::string_view peer);

/// Whether "127.0.0.1:4242" is a peer on this machine.
bool is_local(std::string_view peer);

std::size_t places_of(std::span<const Holder> holders, std::string_view network);

/// The place among `holders`, of which there is at least one, of the one that gives way.
std::size_t gives_way(std::span<const Holder> holders);

}  // namespace playhouse::net
