// Generated from interfaces/022_ir.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// An array of infrared range finders. New drivers use the ranger interface.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::ir {

inline constexpr std::uint16_t kCode = 22;

// Subtypes of messages.
/// Voltages and ranges.
inline constexpr std::uint8_t kDataRanges = 1;
/// Requests the poses of the sensors.
inline constexpr std::uint8_t kReqPose = 1;
/// Switches the sensors on or off.
inline constexpr std::uint8_t kReqPower = 2;

/// Measurements of the sensors.
struct Data {
  /// One per sensor, as measured. [V]
  std::vector<float> voltages{};
  /// One per sensor, computed from the voltage. [m]
  std::vector<float> ranges{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// Poses of the sensors.
struct Pose {
  /// One per sensor; x points along its beam. [frame X_RS, m, m, m, rad, rad, rad]
  std::vector<Pose3d> poses{};

  friend bool operator==(const Pose&, const Pose&) = default;
};

/// The sensors' switch.
struct PowerReq {
  /// 1: on, 0: off.
  std::uint8_t state = 0;

  friend bool operator==(const PowerReq&, const PowerReq&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Pose& m);
void write(Writer& out, const Pose& m);
void to_json(std::string& out, const Pose& m);
void read(Reader& in, PowerReq& m);
void write(Writer& out, const PowerReq& m);
void to_json(std::string& out, const PowerReq& m);

}  // namespace playhouse::wire::ir
