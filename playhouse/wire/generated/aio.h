// Generated from interfaces/021_aio.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Analog inputs and outputs.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::aio {

inline constexpr std::uint16_t kCode = 21;

// Subtypes of messages.
/// Voltages of the inputs.
inline constexpr std::uint8_t kDataState = 1;
/// Commanded voltage of one output.
inline constexpr std::uint8_t kCmdState = 1;

/// Voltages of the inputs.
struct Data {
  /// [V]
  std::vector<float> voltages{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// Commanded voltage of one output.
struct Cmd {
  /// Index of the output.
  std::uint32_t id = 0;
  /// [V]
  float voltage = 0;

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);

}  // namespace playhouse::wire::aio
