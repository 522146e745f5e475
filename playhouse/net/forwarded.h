#pragma once

/// The clients behind reverse proxies, which name them in the header X-Forwarded-For.

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse::net {

/// Reverse proxies whose word is taken for whom a request is from; from anybody else the header is ignored.
class TrustedProxies {
 public:
  /// Most addresses of a list.
  static constexpr std::size_t kMost = 16;

  /// Of numeric addresses: "10.0.0.2" or "10.0.0.2,::1".
  static Result<TrustedProxies> parse(const std::string& list);
  bool empty() const { return addresses_.empty(); }

  /// The client of a request from this peer, "address:port", whose headers X-Forwarded-For are `forwarded`,
  /// joined by commas. Of a trusted proxy: the last address that is of no trusted proxy, else the first one,
  /// with the port of the proxy's connection; what is left of it may be the client's invention, and is not
  /// read. Without the header: the peer. Fails if what is read is no address.
  Result<std::string> client_of(const std::string& peer, std::string_view forwarded) const;

 private:
  std::set<std::string, std::less<>> addresses_;  // as text of their shortest form
};

}  // namespace playhouse::net
