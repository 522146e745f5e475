#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace playhouse::device {

/// Address of a device for clients. `robot` is the TCP port, a name space of its own.
struct Address {
  std::uint32_t robot = 0;
  std::uint16_t interf = 0;  // interface code, e.g. 4 = position2d
  std::uint16_t index = 0;
  friend constexpr auto operator<=>(const Address&, const Address&) = default;
};

/// Handle of a device in the DeviceTable; never reused, not even after the device has retired.
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
