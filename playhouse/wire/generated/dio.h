// Generated from interfaces/020_dio.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::dio {

inline constexpr std::uint16_t kCode = 20;

// Subtypes of messages.
inline constexpr std::uint8_t kDataValues = 1;
inline constexpr std::uint8_t kCmdValues = 1;

struct Data {
  std::uint32_t count = 0;
  std::uint32_t bits = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct Cmd {
  std::uint32_t count = 0;
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
