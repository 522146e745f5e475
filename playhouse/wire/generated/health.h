// Generated from interfaces/059_health.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Load of a computer.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::health {

inline constexpr std::uint16_t kCode = 59;

// Subtypes of messages.
/// Load of processor and memory.
inline constexpr std::uint8_t kDataState = 1;

/// Processor load.
struct Cpu {
  /// Idle time. [%]
  float idle = 0;
  /// Time in the operating system. [%]
  float system = 0;
  /// Time in programs. [%]
  float user = 0;

  friend bool operator==(const Cpu&, const Cpu&) = default;
};

/// Usage of a type of memory.
struct Memory {
  /// [byte]
  std::int64_t total = 0;
  /// [byte]
  std::int64_t used = 0;
  /// [byte]
  std::int64_t free = 0;

  friend bool operator==(const Memory&, const Memory&) = default;
};

/// Load of processor and memory.
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
