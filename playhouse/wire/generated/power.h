// Generated from interfaces/002_power.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Battery and charger of a robot.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::power {

inline constexpr std::uint16_t kCode = 2;

// Subtypes of messages.
/// State of charge.
inline constexpr std::uint8_t kDataState = 1;
/// Says whether the battery may take and give power.
inline constexpr std::uint8_t kReqSetChargingPolicy = 1;

/// Bits of Data.valid: which of the fields hold something.
inline constexpr std::int32_t kMaskVolts = 1;
inline constexpr std::int32_t kMaskWatts = 2;
inline constexpr std::int32_t kMaskJoules = 4;
inline constexpr std::int32_t kMaskPercent = 8;
inline constexpr std::int32_t kMaskCharging = 16;

/// State of charge; only the fields named in `valid` count.
struct Data {
  /// Bits of the fields that hold something.
  std::uint32_t valid = 0;
  /// [V]
  float volts = 0;
  /// Share of a full charge, 0 to 100. [%]
  float percent = 0;
  /// Energy that is left. [J]
  float joules = 0;
  /// Power that flows out of the battery; negative while charging. [W]
  float watts = 0;
  /// 1 charging, 0 not, -1 charging is impossible.
  std::int32_t charging = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Which flows of power are allowed.
struct ChargepolicyConfig {
  /// 1 the battery may be charged.
  std::uint8_t enable_input = 0;
  /// 1 the battery may feed others.
  std::uint8_t enable_output = 0;

  friend bool operator==(const ChargepolicyConfig&, const ChargepolicyConfig&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, ChargepolicyConfig& m);
void write(Writer& out, const ChargepolicyConfig& m);
void to_json(std::string& out, const ChargepolicyConfig& m);

}  // namespace playhouse::wire::power
