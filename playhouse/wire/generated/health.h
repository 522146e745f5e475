// Generated from interfaces/059_health.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::health {

inline constexpr std::uint16_t kCode = 59;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;

struct Cpu {
  /// [1]
  float idle = 0;
  /// [1]
  float system = 0;
  /// [1]
  float user = 0;

  friend bool operator==(const Cpu&, const Cpu&) = default;
};

struct Memory {
  std::int64_t total = 0;
  std::int64_t used = 0;
  std::int64_t free = 0;

  friend bool operator==(const Memory&, const Memory&) = default;
};

struct Data {
  Cpu cpu_usage{};
  Memory mem{};
  Memory swap{};

  friend bool operator==(const Data&, const Data&) = default;
};

void read(Reader& in, Cpu& m);
void write(Writer& out, const Cpu& m);
void to_json(std::string& out, const Cpu& m);
void read(Reader& in, Memory& m);
void write(Writer& out, const Memory& m);
void to_json(std::string& out, const Memory& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);

}  // namespace playhouse::wire::health
