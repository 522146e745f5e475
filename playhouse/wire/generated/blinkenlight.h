// Generated from interfaces/033_blinkenlight.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::blinkenlight {

inline constexpr std::uint16_t kCode = 33;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kCmdState = 1;
inline constexpr std::uint8_t kCmdPower = 2;
inline constexpr std::uint8_t kCmdColor = 3;
inline constexpr std::uint8_t kCmdFlash = 4;

struct Data {
  std::uint8_t enable = 0;
  /// [s]
  float period = 0;
  /// [ratio]
  float dutycycle = 0;
  Color color{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct Cmd {
  std::uint16_t id = 0;
  std::uint8_t enable = 0;
  /// [s]
  float period = 0;
  /// [ratio]
  float dutycycle = 0;
  Color color{};

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

struct CmdPower {
  std::uint16_t id = 0;
  std::uint8_t enable = 0;

  friend bool operator==(const CmdPower&, const CmdPower&) = default;
};

struct CmdColor {
  std::uint16_t id = 0;
  Color color{};

  friend bool operator==(const CmdColor&, const CmdColor&) = default;
};

struct CmdFlash {
  std::uint16_t id = 0;
  /// [s]
  float period = 0;
  /// [ratio]
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
