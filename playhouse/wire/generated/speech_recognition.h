// Generated from interfaces/050_speech_recognition.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Reports recognised speech.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::speech_recognition {

inline constexpr std::uint16_t kCode = 50;

// Subtypes of messages.
/// Recognised words.
inline constexpr std::uint8_t kDataString = 1;

/// Recognised speech.
struct Data {
  /// NUL-terminated.
  std::string text{};

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::speech_recognition
