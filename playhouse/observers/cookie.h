#pragma once

/// Stateless address validation (as DTLS cookies), against spoofed-source amplification: what an address has
/// to send back before it gets more than it sent. A cookie is a hash of the address, of what it said and of
/// the time.

#include <cstdint>

#include "playhouse/base/siphash.h"
#include "playhouse/net/endpoint.h"

namespace playhouse::observers {

class Cookies {
 public:
  /// With a key at random, or, for tests, this one.
  Cookies();
  explicit Cookies(const SipKey& key) : key_(key) {}

  std::uint64_t make(const net::Endpoint& peer, std::uint64_t nonce, double now) const;
  /// Whether it was made for this peer in the last seconds.
  bool is_good(std::uint64_t cookie, const net::Endpoint& peer, std::uint64_t nonce, double now) const;

  static constexpr double kLifeSeconds = 8;  // at least, and at most twice that

 private:
  std::uint64_t of(const net::Endpoint& peer, std::uint64_t nonce, std::uint64_t period) const;
  SipKey key_;
};

/// A number that nobody can guess.
std::uint64_t random_number();

}  // namespace playhouse::observers
