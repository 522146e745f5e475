// Generated from interfaces/002_power.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::power {

inline constexpr std::uint16_t kCode = 2;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kReqSetChargingPolicy = 1;

inline constexpr std::int32_t kMaskVolts = 1;
inline constexpr std::int32_t kMaskWatts = 2;
inline constexpr std::int32_t kMaskJoules = 4;
inline constexpr std::int32_t kMaskPercent = 8;
inline constexpr std::int32_t kMaskCharging = 16;

struct Data {
  std::uint32_t valid = 0;
  /// [V]
  float volts = 0;
  /// [%]
  float percent = 0;
  /// [J]
  float joules = 0;
  /// [W]
  float watts = 0;
  std::int32_t charging = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct ChargepolicyConfig {
  std::uint8_t enable_input = 0;
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
