#include "playhouse/observers/cookie.h"

#include <sys/random.h>

#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/packing.h"

namespace playhouse::observers {
namespace {

std::uint64_t period_of(double now) {
  return static_cast<std::uint64_t>(now / Cookies::kLifeSeconds) + 1;
}

}  // namespace

std::uint64_t random_number() {
  std::uint64_t number = 0;
  PLAYHOUSE_ASSERT(getrandom(&number, sizeof number, 0) == sizeof number);
  return number;
}

Cookies::Cookies() : key_{random_number(), random_number()} {}

std::uint64_t Cookies::make(const net::Endpoint& peer, std::uint64_t nonce, double now) const {
  return of(peer, nonce, period_of(now));
}

bool Cookies::is_good(std::uint64_t cookie, const net::Endpoint& peer, std::uint64_t nonce,
                      double now) const {
  const std::uint64_t period = period_of(now);
  return cookie == of(peer, nonce, period) || cookie == of(peer, nonce, period - 1);
}

std::uint64_t Cookies::of(const net::Endpoint& peer, std::uint64_t nonce, std::uint64_t period) const {
  std::vector<std::byte> bytes;
  Packer pack(bytes);
  for (const std::uint8_t byte : peer.address) pack.u8(byte);
  pack.u16(peer.port);
  pack.u32(peer.scope);
  pack.u64(nonce);
  pack.u64(period);
  return siphash(key_, bytes);
}

}  // namespace playhouse::observers
