#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace playhouse::device {

/// A device as clients address it. `robot` is the TCP port whose name space the device lives in.
struct Address {
  std::uint32_t robot = 0;
  std::uint16_t interf = 0;  // interface code, e.g. 4 = position2d
  std::uint16_t index = 0;
  friend constexpr auto operator<=>(const Address&, const Address&) = default;
};

/// A device in the DeviceTable; never reused while the server runs, also after the device retired.
struct DeviceId {
  std::uint32_t row = 0xFFFFFFFFu;
  constexpr bool valid() const { return row != 0xFFFFFFFFu; }
  friend constexpr auto operator<=>(DeviceId, DeviceId) = default;
};

}  // namespace playhouse::device

template <>
struct std::hash<playhouse::device::DeviceId> {
  std::size_t operator()(playhouse::device::DeviceId id) const noexcept { return id.row; }
};
