#pragma once

/// Stateless cookies (as in DTLS) against amplification with spoofed source
/// addresses: a peer has to return a cookie before it gets more bytes than
/// it sent. A cookie is a keyed hash of the address, the nonce and the time.

#include <cstdint>

#include "playhouse/observers/siphash.h"
#include "playhouse/net/endpoint.h"

namespace playhouse::observers {

class Cookies {
 public:
  /// With a random key, or, for tests, this one.
  Cookies();
  explicit Cookies(const SipKey& key) : key_(key) {}

  std::uint64_t make(const net::Endpoint& peer, std::uint64_t nonce, double now) const;
  /// True if the cookie was made for this peer and is not expired.
  bool is_good(std::uint64_t cookie, const net::Endpoint& peer, std::uint64_t nonce, double now) const;

  static constexpr double kLifeSeconds = 8;  // lower bound of the lifetime; the upper bound is twice that

 private:
  std::uint64_t of(const net::Endpoint& peer, std::uint64_t nonce, std::uint64_t period) const;
  SipKey key_;
};

/// A cryptographically random number.
std::uint64_t random_number();

}  // namespace playhouse::observers
