// Generated from interfaces/050_speech_recognition.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Tells what was said.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::speech_recognition {

inline constexpr std::uint16_t kCode = 50;

// Subtypes of messages.
/// The words that were understood.
inline constexpr std::uint8_t kDataString = 1;

/// What was said.
struct Data {
  /// With its final NUL.
  std::string text{};

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::speech_recognition
