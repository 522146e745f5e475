#pragma once

/// Endpoint: address of a datagram socket, as a value.

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <tuple>

#include "playhouse/base/result.h"

namespace playhouse::net {

struct Endpoint {
  std::array<std::uint8_t, 16> address{};  // IPv6; IPv4 addresses are mapped, ::ffff:a.b.c.d
  std::uint16_t port = 0;
  std::uint32_t scope = 0;  // zone (interface) of a link-local address
  /// Of a peer that was heard: the address of this machine that it spoke to, which answers to it come from; zeros: the
  /// system chooses. It is not compared: a peer is the same whichever of our addresses it uses.
  std::array<std::uint8_t, 16> spoken_to{};

  bool is_v4() const;
  /// A group of IPv4, 224.0.0.0/4.
  bool is_group() const;
  friend auto operator<=>(const Endpoint& a, const Endpoint& b) {
    return std::tie(a.address, a.port, a.scope) <=> std::tie(b.address, b.port, b.scope);
  }
  friend bool operator==(const Endpoint& a, const Endpoint& b) { return (a <=> b) == 0; }
};

/// "10.0.0.7:4242" or "[fe80::1]:4242".
std::string to_text(const Endpoint& endpoint);

/// Parses a numeric address or "localhost". Fails on anything else.
Result<Endpoint> parse_endpoint(const std::string& address, std::uint16_t port);

/// Resolves host names too, by the system: may block.
Result<Endpoint> resolve(const std::string& host, std::uint16_t port);

}  // namespace playhouse::net
