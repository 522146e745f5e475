#pragma once

/// SipHash-2-4: a keyed hash, unpredictable without the key. Source:
/// Aumasson, Bernstein, "SipHash: a fast short-input PRF" (2012).

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace playhouse::observers {

using SipKey = std::array<std::uint64_t, 2>;

inline std::uint64_t siphash(const SipKey& key, std::span<const std::byte> bytes) {
  std::uint64_t a = key[0] ^ 0x736f6d6570736575u, b = key[1] ^ 0x646f72616e646f6du;
  std::uint64_t c = key[0] ^ 0x6c7967656e657261u, d = key[1] ^ 0x7465646279746573u;
  const auto rounds = [&](int count) {
    for (; count > 0; --count) {
      a += b, c += d;
      b = std::rotl(b, 13) ^ a, d = std::rotl(d, 16) ^ c;
      a = std::rotl(a, 32);
      c += b, a += d;
      b = std::rotl(b, 17) ^ c, d = std::rotl(d, 21) ^ a;
      c = std::rotl(c, 32);
    }
  };
  const auto mix = [&](std::uint64_t word) {
    d ^= word;
    rounds(2);
    a ^= word;
  };
  std::uint64_t word = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    word |= std::uint64_t{std::to_integer<std::uint8_t>(bytes[k])} << 8 * (k % 8);
    if (k % 8 == 7) {
      mix(word);
      word = 0;
    }
  }
  mix(word | std::uint64_t{bytes.size()} << 56);
  c ^= 0xFF;
  rounds(4);
  return a ^ b ^ c ^ d;
}

}  // namespace playhouse::observers
