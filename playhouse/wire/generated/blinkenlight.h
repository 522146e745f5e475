// Generated from interfaces/033_blinkenlight.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Lights that can be switched, colored and made to blink.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::blinkenlight {

inline constexpr std::uint16_t kCode = 33;

// Subtypes of messages.
/// State of the light.
inline constexpr std::uint8_t kDataState = 1;
/// Sets all properties of one light.
inline constexpr std::uint8_t kCmdState = 1;
/// Switches one light.
inline constexpr std::uint8_t kCmdPower = 2;
/// Colors one light.
inline constexpr std::uint8_t kCmdColor = 3;
/// Makes one light blink.
inline constexpr std::uint8_t kCmdFlash = 4;

/// State of the light.
struct Data {
  /// 1: on, 0: off.
  std::uint8_t enable = 0;
  /// Blinking period; 0: steady light. [s]
  float period = 0;
  /// Duty cycle: fraction of the period in which the light is on, 0 to 1. [1]
  float dutycycle = 0;
  Color color{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// Commanded state of one light.
struct Cmd {
  /// Index of the light.
  std::uint16_t id = 0;
  /// 1: on, 0: off.
  std::uint8_t enable = 0;
  /// Blinking period; 0: steady light. [s]
  float period = 0;
  /// Duty cycle: fraction of the period in which the light is on, 0 to 1. [1]
  float dutycycle = 0;
  Color color{};

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

/// Switch of one light.
struct CmdPower {
  /// Index of the light.
  std::uint16_t id = 0;
  /// 1: on, 0: off.
  std::uint8_t enable = 0;

  friend bool operator==(const CmdPower&, const CmdPower&) = default;
};

/// Color of one light.
struct CmdColor {
  /// Index of the light.
  std::uint16_t id = 0;
  Color color{};

  friend bool operator==(const CmdColor&, const CmdColor&) = default;
};

/// Blinking of one light.
struct CmdFlash {
  /// Index of the light.
  std::uint16_t id = 0;
  /// Blinking period. [s]
  float period = 0;
  /// Duty cycle: fraction of the period in which the light is on, 0 to 1. [1]
  float dutycycle = 0;

  friend bool operator==(const CmdFlash&, const CmdFlash&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);
void read(Reader& in, CmdPower& m);
void write(Writer& out, const CmdPower& m);
void to_json(std::string& out, const CmdPower& m);
void read(Reader& in, CmdColor& m);
void write(Writer& out, const CmdColor& m);
void to_json(std::string& out, const CmdColor& m);
void read(Reader& in, CmdFlash& m);
void write(Writer& out, const CmdFlash& m);
void to_json(std::string& out, const CmdFlash& m);

}  // namespace playhouse::wire::blinkenlight
