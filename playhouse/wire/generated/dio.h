// Generated from interfaces/020_dio.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Digital inputs and outputs.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::dio {

inline constexpr std::uint16_t kCode = 20;

// Subtypes of messages.
/// State of the inputs.
inline constexpr std::uint8_t kDataValues = 1;
/// Commanded state of the outputs.
inline constexpr std::uint8_t kCmdValues = 1;

/// State of the inputs.
struct Data {
  /// Number of valid bits.
  std::uint32_t count = 0;
  /// One bit per input, the first in the lowest bit.
  std::uint32_t bits = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Commanded state of the outputs.
struct Cmd {
  /// Number of valid bits.
  std::uint32_t count = 0;
  /// One bit per output, the first in the lowest bit.
  std::uint32_t digout = 0;

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);

}  // namespace playhouse::wire::dio
