// Generated from interfaces/031_simulation.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::simulation {

inline constexpr std::uint16_t kCode = 31;

// Subtypes of messages.
inline constexpr std::uint8_t kCmdPause = 1;
inline constexpr std::uint8_t kCmdReset = 2;
inline constexpr std::uint8_t kCmdSave = 3;
inline constexpr std::uint8_t kReqGetPose2d = 1;
inline constexpr std::uint8_t kReqSetPose2d = 2;
inline constexpr std::uint8_t kReqGetPose3d = 3;
inline constexpr std::uint8_t kReqSetPose3d = 4;
inline constexpr std::uint8_t kReqGetProperty = 5;
inline constexpr std::uint8_t kReqSetProperty = 6;

struct Data {
  std::uint8_t data = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct Cmd {
  std::uint8_t cmd = 0;

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

struct Pose2dReq {
  std::string name{};
  /// [frame X_RS, m, m, rad]
  Pose2d pose{};

  friend bool operator==(const Pose2dReq&, const Pose2dReq&) = default;
};

struct Pose3dReq {
  std::string name{};
  /// [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// [s]
  double simtime = 0;

  friend bool operator==(const Pose3dReq&, const Pose3dReq&) = default;
};

struct PropertyReq {
  std::string name{};
  std::string prop{};
  std::uint32_t index = 0;
  std::string value{};

  friend bool operator==(const PropertyReq&, const PropertyReq&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);
void read(Reader& in, Pose2dReq& m);
void write(Writer& out, const Pose2dReq& m);
void to_json(std::string& out, const Pose2dReq& m);
void read(Reader& in, Pose3dReq& m);
void write(Writer& out, const Pose3dReq& m);
void to_json(std::string& out, const Pose3dReq& m);
void read(Reader& in, PropertyReq& m);
void write(Writer& out, const PropertyReq& m);
void to_json(std::string& out, const PropertyReq& m);

}  // namespace playhouse::wire::simulation
