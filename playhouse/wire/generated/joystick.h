// Generated from interfaces/049_joystick.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A joystick or gamepad.

#include <array>
#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::joystick {

inline constexpr std::uint16_t kCode = 49;

// Subtypes of messages.
/// Sticks and buttons.
inline constexpr std::uint8_t kDataState = 1;

/// Sticks and buttons.
struct Data {
  /// One per axis, from -scale to scale.
  std::array<std::int32_t, 8> pos{};
  /// Maximum value per axis.
  std::array<std::int32_t, 8> scale{};
  /// One bit per button, the first in the lowest bit.
  std::uint32_t buttons = 0;
  /// Number of axes.
  std::uint32_t axes_count = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::joystick
