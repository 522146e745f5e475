// Generated from interfaces/012_speech.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Speaks text.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::speech {

inline constexpr std::uint16_t kCode = 12;

// Subtypes of messages.
/// Speaks a text; texts are spoken one after the other.
inline constexpr std::uint8_t kCmdSay = 1;

/// A text to speak.
struct Cmd {
  /// NUL-terminated.
  std::string string{};

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);

}  // namespace playhouse::wire::speech
