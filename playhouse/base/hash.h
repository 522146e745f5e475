#pragma once

/// A 64-bit hash of state for reproducibility checks (not
/// cryptographic). A function of the values and their order.

#include <bit>
#include <cstdint>
#include <span>

#include "playhouse/base/rng.h"

namespace playhouse {

class Hash {
 public:
  void add(std::uint64_t value) { state_ = mix64(state_ ^ value) + 0x632BE59BD9B4E019u; }
  /// Hashes the bits; -0 is hashed as 0, so that equal numbers have equal hashes.
  void add(double value) { add(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value)); }
  void add(float value) {
    add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value == 0.0f ? 0.0f : value)));
  }
  template <typename T>
  void add(std::span<const T> values) {
    for (const T& value : values) add(value);
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x243F6A8885A308D3u;
};

}  // namespace playhouse
