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
/// Enables or disables charging and discharging of the battery.
inline constexpr std::uint8_t kReqSetChargingPolicy = 1;

/// Bits of Data.valid: valid fields.
inline constexpr std::int32_t kMaskVolts = 1;
inline constexpr std::int32_t kMaskWatts = 2;
inline constexpr std::int32_t kMaskJoules = 4;
inline constexpr std::int32_t kMaskPercent = 8;
inline constexpr std::int32_t kMaskCharging = 16;

/// State of charge; only the fields flagged in `valid` apply.
struct Data {
  /// Bits of the valid fields.
  std::uint32_t valid = 0;
  /// [V]
  float volts = 0;
  /// Percentage of a full charge, 0 to 100. [%]
  float percent = 0;
  /// Remaining energy. [J]
  float joules = 0;
  /// Power drawn from the battery; negative while charging. [W]
  float watts = 0;
  /// 1 charging, 0 not, -1 charging is impossible.
  std::int32_t charging = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// Enabled flows of power.
struct ChargepolicyConfig {
  /// 1: the battery may be charged.
  std::uint8_t enable_input = 0;
  /// 1: the battery may supply others.
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
