#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace playhouse {

/// Typed index of a row in one table; indices of different tables do not mix. The default is "none".
template <typename Table>
struct Row {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::uint32_t index = kNone;

  constexpr bool valid() const { return index != kNone; }
  constexpr explicit operator bool() const { return valid(); }
  constexpr auto operator<=>(const Row&) const = default;
};

}  // namespace playhouse
