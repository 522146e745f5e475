#include "playhouse/net/endpoint.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstring>

namespace playhouse::net {
namespace {

constexpr std::array<std::uint8_t, 12> kMapped = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF};

/// Resolves by the system, numerically or by name.
Result<Endpoint> look_up(const std::string& host, std::uint16_t port, int flags) {
  addrinfo wanted{};
  wanted.ai_family = AF_UNSPEC;
  wanted.ai_socktype = SOCK_DGRAM;
  wanted.ai_flags = flags;
  addrinfo* found = nullptr;
  if (const int failed = getaddrinfo(host.c_str(), nullptr, &wanted, &found); failed != 0)
    return Error{host, gai_strerror(failed)};
  Endpoint endpoint;
  endpoint.port = port;
  if (found->ai_family == AF_INET6) {
    sockaddr_in6 six;
    std::memcpy(&six, found->ai_addr, sizeof six);
    std::memcpy(endpoint.address.data(), &six.sin6_addr, 16);
    endpoint.scope = six.sin6_scope_id;
  } else {
    sockaddr_in four;
    std::memcpy(&four, found->ai_addr, sizeof four);
    std::ranges::copy(kMapped, endpoint.address.begin());
    std::memcpy(endpoint.address.data() + kMapped.size(), &four.sin_addr, 4);
  }
  freeaddrinfo(found);
  return endpoint;
}

}  // namespace

bool Endpoint::is_v4() const {
  return std::equal(kMapped.begin(), kMapped.end(), address.begin());
}

bool Endpoint::is_group() const {
  return is_v4() && address[kMapped.size()] >> 4 == 0xE;
}

std::string to_text(const Endpoint& endpoint) {
  char text[INET6_ADDRSTRLEN] = {};
  if (endpoint.is_v4()) {
    inet_ntop(AF_INET, endpoint.address.data() + kMapped.size(), text, sizeof text);
    return std::string(text) + ":" + std::to_string(endpoint.port);
  }
  inet_ntop(AF_INET6, endpoint.address.data(), text, sizeof text);
  return "[" + std::string(text) + "]:" + std::to_string(endpoint.port);
}

Result<Endpoint> parse_endpoint(const std::string& address, std::uint16_t port) {
  const auto found = look_up(address == "localhost" ? "127.0.0.1" : address, port, AI_NUMERICHOST);
  if (!found) return Error{address, "is not an IPv4 or IPv6 address"};
  return found;
}

Result<Endpoint> resolve(const std::string& host, std::uint16_t port) {
  return look_up(host, port, 0);
}

}  // namespace playhouse::net
