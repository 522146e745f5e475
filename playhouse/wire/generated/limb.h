// Generated from interfaces/054_limb.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::limb {

inline constexpr std::uint16_t kCode = 54;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kCmdHome = 1;
inline constexpr std::uint8_t kCmdStop = 2;
inline constexpr std::uint8_t kCmdSetpose = 3;
inline constexpr std::uint8_t kCmdSetposition = 4;
inline constexpr std::uint8_t kCmdVecmove = 5;
inline constexpr std::uint8_t kReqPower = 1;
inline constexpr std::uint8_t kReqBrakes = 2;
inline constexpr std::uint8_t kReqGeom = 3;
inline constexpr std::uint8_t kReqSpeed = 4;

inline constexpr std::int32_t kStateIdle = 1;
inline constexpr std::int32_t kStateBraked = 2;
inline constexpr std::int32_t kStateMoving = 3;
inline constexpr std::int32_t kStateOor = 4;
inline constexpr std::int32_t kStateColl = 5;

struct Data {
  /// [frame p_WP]
  Point3d position{};
  /// [frame p_WP]
  Point3d approach{};
  /// [frame p_WP]
  Point3d orientation{};
  std::uint8_t state = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct SetposeCmd {
  /// [frame p_WP]
  Point3d position{};
  /// [frame p_WP]
  Point3d approach{};
  /// [frame p_WP]
  Point3d orientation{};

  friend bool operator==(const SetposeCmd&, const SetposeCmd&) = default;
};

struct SetpositionCmd {
  /// [frame p_WP]
  Point3d position{};

  friend bool operator==(const SetpositionCmd&, const SetpositionCmd&) = default;
};

struct VecmoveCmd {
  /// [frame p_WP]
  Point3d direction{};
  /// [m]
  float length = 0;

  friend bool operator==(const VecmoveCmd&, const VecmoveCmd&) = default;
};

struct PowerReq {
  std::uint8_t value = 0;

  friend bool operator==(const PowerReq&, const PowerReq&) = default;
};

struct BrakesReq {
  std::uint8_t value = 0;

  friend bool operator==(const BrakesReq&, const BrakesReq&) = default;
};

struct GeomReq {
  /// [frame p_WP]
  Point3d basePos{};

  friend bool operator==(const GeomReq&, const GeomReq&) = default;
};

struct SpeedReq {
  /// [m/s]
  float speed = 0;

  friend bool operator==(const SpeedReq&, const SpeedReq&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, SetposeCmd& m);
void write(Writer& out, const SetposeCmd& m);
void to_json(std::string& out, const SetposeCmd& m);
void read(Reader& in, SetpositionCmd& m);
void write(Writer& out, const SetpositionCmd& m);
void to_json(std::string& out, const SetpositionCmd& m);
void read(Reader& in, VecmoveCmd& m);
void write(Writer& out, const VecmoveCmd& m);
void to_json(std::string& out, const VecmoveCmd& m);
void read(Reader& in, PowerReq& m);
void write(Writer& out, const PowerReq& m);
void to_json(std::string& out, const PowerReq& m);
void read(Reader& in, BrakesReq& m);
void write(Writer& out, const BrakesReq& m);
void to_json(std::string& out, const BrakesReq& m);
void read(Reader& in, GeomReq& m);
void write(Writer& out, const GeomReq& m);
void to_json(std::string& out, const GeomReq& m);
void read(Reader& in, SpeedReq& m);
void write(Writer& out, const SpeedReq& m);
void to_json(std::string& out, const SpeedReq& m);

}  // namespace playhouse::wire::limb
