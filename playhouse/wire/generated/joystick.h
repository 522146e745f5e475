// Generated from interfaces/049_joystick.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <array>
#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::joystick {

inline constexpr std::uint16_t kCode = 49;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;

struct Data {
  std::array<std::int32_t, 8> pos{};
  std::array<std::int32_t, 8> scale{};
  std::uint32_t buttons = 0;
  std::uint32_t axes_count = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::joystick
