// Generated from interfaces/000_common.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/codec.h"

namespace playhouse::wire {

// Subtypes of messages.
inline constexpr std::uint8_t kReqSetBoolprop = 247;
inline constexpr std::uint8_t kReqGetBoolprop = 248;
inline constexpr std::uint8_t kReqSetStrprop = 249;
inline constexpr std::uint8_t kReqGetStrprop = 250;
inline constexpr std::uint8_t kReqSetDblprop = 251;
inline constexpr std::uint8_t kReqGetDblprop = 252;
inline constexpr std::uint8_t kReqSetIntprop = 253;
inline constexpr std::uint8_t kReqGetIntprop = 254;
inline constexpr std::uint8_t kReqCapabilities = 255;

/// Limits that every implementation of the protocol shares.
inline constexpr std::int32_t kMaxMessageSize = 8388608;
inline constexpr std::int32_t kMaxDriverStringLen = 64;
inline constexpr std::int32_t kMaxDevices = 4096;
inline constexpr std::int32_t kMsgqueueDefaultMaxlen = 1024;
inline constexpr std::int32_t kIdentStrlen = 32;
inline constexpr std::int32_t kKeylen = 32;

struct Devaddr {
  std::uint32_t host = 0;
  std::uint32_t robot = 0;
  std::uint16_t interf = 0;
  std::uint16_t index = 0;

  friend bool operator==(const Devaddr&, const Devaddr&) = default;
};

struct Point2d {
  /// [m]
  double px = 0;
  /// [m]
  double py = 0;

  friend bool operator==(const Point2d&, const Point2d&) = default;
};

struct Point3d {
  /// [m]
  double px = 0;
  /// [m]
  double py = 0;
  /// [m]
  double pz = 0;

  friend bool operator==(const Point3d&, const Point3d&) = default;
};

struct Orientation3d {
  /// [rad]
  double proll = 0;
  /// [rad]
  double ppitch = 0;
  /// [rad]
  double pyaw = 0;

  friend bool operator==(const Orientation3d&, const Orientation3d&) = default;
};

struct Pose2d {
  /// [m]
  double px = 0;
  /// [m]
  double py = 0;
  /// [rad]
  double pa = 0;

  friend bool operator==(const Pose2d&, const Pose2d&) = default;
};

struct Pose3d {
  /// [m]
  double px = 0;
  /// [m]
  double py = 0;
  /// [m]
  double pz = 0;
  /// [rad]
  double proll = 0;
  /// [rad]
  double ppitch = 0;
  /// [rad]
  double pyaw = 0;

  friend bool operator==(const Pose3d&, const Pose3d&) = default;
};

struct Bbox2d {
  /// [m]
  double sw = 0;
  /// [m]
  double sl = 0;

  friend bool operator==(const Bbox2d&, const Bbox2d&) = default;
};

struct Bbox3d {
  /// [m]
  double sw = 0;
  /// [m]
  double sl = 0;
  /// [m]
  double sh = 0;

  friend bool operator==(const Bbox3d&, const Bbox3d&) = default;
};

struct BlackboardEntry {
  std::string key{};
  std::string group{};
  std::uint16_t type = 0;
  std::uint16_t subtype = 0;
  std::vector<std::uint8_t> data{};
  /// [s]
  std::uint32_t timestamp_sec = 0;
  /// [us]
  std::uint32_t timestamp_usec = 0;

  friend bool operator==(const BlackboardEntry&, const BlackboardEntry&) = default;
};

struct Segment {
  /// [m]
  double x0 = 0;
  /// [m]
  double y0 = 0;
  /// [m]
  double x1 = 0;
  /// [m]
  double y1 = 0;

  friend bool operator==(const Segment&, const Segment&) = default;
};

struct Extent2d {
  /// [m]
  double x0 = 0;
  /// [m]
  double y0 = 0;
  /// [m]
  double x1 = 0;
  /// [m]
  double y1 = 0;

  friend bool operator==(const Extent2d&, const Extent2d&) = default;
};

struct Color {
  std::uint8_t alpha = 0;
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Color&, const Color&) = default;
};

struct Bool {
  std::uint8_t state = 0;

  friend bool operator==(const Bool&, const Bool&) = default;
};

struct Uint32 {
  std::uint32_t value = 0;

  friend bool operator==(const Uint32&, const Uint32&) = default;
};

struct CapabilitiesReq {
  std::uint32_t type = 0;
  std::uint32_t subtype = 0;

  friend bool operator==(const CapabilitiesReq&, const CapabilitiesReq&) = default;
};

struct BoolpropReq {
  std::string key{};
  char value = 0;

  friend bool operator==(const BoolpropReq&, const BoolpropReq&) = default;
};

struct IntpropReq {
  std::string key{};
  std::int32_t value = 0;

  friend bool operator==(const IntpropReq&, const IntpropReq&) = default;
};

struct DblpropReq {
  std::string key{};
  /// [1]
  double value = 0;

  friend bool operator==(const DblpropReq&, const DblpropReq&) = default;
};

struct StrpropReq {
  std::string key{};
  std::string value{};

  friend bool operator==(const StrpropReq&, const StrpropReq&) = default;
};

void read(Reader& in, Devaddr& m);
void write(Writer& out, const Devaddr& m);
void to_json(std::string& out, const Devaddr& m);
void read(Reader& in, Point2d& m);
void write(Writer& out, const Point2d& m);
void to_json(std::string& out, const Point2d& m);
void read(Reader& in, Point3d& m);
void write(Writer& out, const Point3d& m);
void to_json(std::string& out, const Point3d& m);
void read(Reader& in, Orientation3d& m);
void write(Writer& out, const Orientation3d& m);
void to_json(std::string& out, const Orientation3d& m);
void read(Reader& in, Pose2d& m);
void write(Writer& out, const Pose2d& m);
void to_json(std::string& out, const Pose2d& m);
void read(Reader& in, Pose3d& m);
void write(Writer& out, const Pose3d& m);
void to_json(std::string& out, const Pose3d& m);
void read(Reader& in, Bbox2d& m);
void write(Writer& out, const Bbox2d& m);
void to_json(std::string& out, const Bbox2d& m);
void read(Reader& in, Bbox3d& m);
void write(Writer& out, const Bbox3d& m);
void to_json(std::string& out, const Bbox3d& m);
void read(Reader& in, BlackboardEntry& m);
void write(Writer& out, const BlackboardEntry& m);
void to_json(std::string& out, const BlackboardEntry& m);
void read(Reader& in, Segment& m);
void write(Writer& out, const Segment& m);
void to_json(std::string& out, const Segment& m);
void read(Reader& in, Extent2d& m);
void write(Writer& out, const Extent2d& m);
void to_json(std::string& out, const Extent2d& m);
void read(Reader& in, Color& m);
void write(Writer& out, const Color& m);
void to_json(std::string& out, const Color& m);
void read(Reader& in, Bool& m);
void write(Writer& out, const Bool& m);
void to_json(std::string& out, const Bool& m);
void read(Reader& in, Uint32& m);
void write(Writer& out, const Uint32& m);
void to_json(std::string& out, const Uint32& m);
void read(Reader& in, CapabilitiesReq& m);
void write(Writer& out, const CapabilitiesReq& m);
void to_json(std::string& out, const CapabilitiesReq& m);
void read(Reader& in, BoolpropReq& m);
void write(Writer& out, const BoolpropReq& m);
void to_json(std::string& out, const BoolpropReq& m);
void read(Reader& in, IntpropReq& m);
void write(Writer& out, const IntpropReq& m);
void to_json(std::string& out, const IntpropReq& m);
void read(Reader& in, DblpropReq& m);
void write(Writer& out, const DblpropReq& m);
void to_json(std::string& out, const DblpropReq& m);
void read(Reader& in, StrpropReq& m);
void write(Writer& out, const StrpropReq& m);
void to_json(std::string& out, const StrpropReq& m);

}  // namespace playhouse::wire
