// Generated from interfaces/022_ir.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::ir {

inline constexpr std::uint16_t kCode = 22;

// Subtypes of messages.
inline constexpr std::uint8_t kDataRanges = 1;
inline constexpr std::uint8_t kReqPose = 1;
inline constexpr std::uint8_t kReqPower = 2;

struct Data {
  /// [V]
  std::vector<float> voltages{};
  /// [m]
  std::vector<float> ranges{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct Pose {
  /// [frame X_RS]
  std::vector<Pose3d> poses{};

  friend bool operator==(const Pose&, const Pose&) = default;
};

struct PowerReq {
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
