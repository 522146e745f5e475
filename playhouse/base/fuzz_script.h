#pragma once

/// For fuzzers: reads the input as a script of operations. Past its end it reads zeros.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace playhouse {

class FuzzScript {
 public:
  explicit FuzzScript(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool done() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const auto value = static_cast<std::uint8_t>(bytes_.front());
    bytes_ = bytes_.subspan(1);
    return value;
  }
  /// Up to `count` bytes.
  std::span<const std::byte> take(std::size_t count) {
    const auto result = bytes_.first(std::min(count, bytes_.size()));
    bytes_ = bytes_.subspan(result.size());
    return result;
  }
  /// One byte encodes an ordinary number or a pathological one; its last value announces eight raw bytes.
  double number() {
    using Limits = std::numeric_limits<double>;
    constexpr std::array kHurtful = {Limits::infinity(),
                                     -Limits::infinity(),
                                     Limits::quiet_NaN(),
                                     Limits::max(),
                                     Limits::lowest(),
                                     Limits::min(),
                                     Limits::denorm_min(),
                                     -0.0,
                                     1e6,
                                     -1e6,
                                     1e9,
                                     1e15,
                                     1e-9,
                                     1e-15};
    const std::uint8_t kind = byte();
    if (kind < 0xF0) return (kind - 0x78) / 16.0;
    if (kind < 0xFF) return kHurtful[kind - 0xF0u < kHurtful.size() ? kind - 0xF0u : 0];
    double any = 0;
    const auto raw = take(sizeof any);
    std::memcpy(&any, raw.data(), raw.size());
    return any;
  }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace playhouse
