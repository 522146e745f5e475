#pragma once

/// Endpoint: address of a datagram socket, as a value.

#include <array>
#include <compare>
#include <cstdint>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::net {

struct Endpoint {
  std::array<std::uint8_t, 16> address{};  // IPv6; IPv4 addresses are mapped, ::ffff:a.b.c.d
  std::uint16_t port = 0;
  std::uint32_t scope = 0;  // zone (interface) of a link-local address

  bool is_v4() const;
  friend auto operator<=>(const Endpoint&, const Endpoint&) = default;
};

/// "10.0.0.7:4242" or "[fe80::1]:4242".
std::string to_text(const Endpoint& endpoint);

/// Parses a numeric address or "localhost". Fails on anything else.
Result<Endpoint> parse_endpoint(const std::string& address, std::uint16_t port);

/// Resolves host names too, by the system: may block.
Result<Endpoint> resolve(const std::string& host, std::uint16_t port);

}  // namespace playhouse::net
