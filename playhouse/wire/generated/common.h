// Generated from interfaces/000_common.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Types shared by several interfaces, and requests to any device.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/codec.h"

namespace playhouse::wire {

// Subtypes of messages.
/// Changes a named switch of the driver.
inline constexpr std::uint8_t kReqSetBoolprop = 247;
/// Reads a named switch of the driver; the answer repeats the key.
inline constexpr std::uint8_t kReqGetBoolprop = 248;
/// Changes a named string of the driver.
inline constexpr std::uint8_t kReqSetStrprop = 249;
/// Reads a named string of the driver; the answer repeats the key.
inline constexpr std::uint8_t kReqGetStrprop = 250;
/// Changes a named number of the driver.
inline constexpr std::uint8_t kReqSetDblprop = 251;
/// Reads a named number of the driver; the answer repeats the key.
inline constexpr std::uint8_t kReqGetDblprop = 252;
/// Changes a named integer of the driver.
inline constexpr std::uint8_t kReqSetIntprop = 253;
/// Reads a named integer of the driver; the answer repeats the key.
inline constexpr std::uint8_t kReqGetIntprop = 254;
/// Queries whether the device supports a message: an empty ACK means yes, NACK no.
inline constexpr std::uint8_t kReqCapabilities = 255;

/// Limits shared by all implementations of the protocol.
inline constexpr std::int32_t kMaxMessageSize = 8388608;
inline constexpr std::int32_t kMaxDriverStringLen = 64;
inline constexpr std::int32_t kMaxDevices = 4096;
inline constexpr std::int32_t kMsgqueueDefaultMaxlen = 1024;
inline constexpr std::int32_t kIdentStrlen = 32;
inline constexpr std::int32_t kKeylen = 32;

/// Address of a device.
struct Devaddr {
  /// Host of the device's server; receivers compare only interf and index.
  std::uint32_t host = 0;
  /// TCP port of the device's server: its name space.
  std::uint32_t robot = 0;
  /// Interface code.
  std::uint16_t interf = 0;
  /// Index of the device within its interface.
  std::uint16_t index = 0;

  friend bool operator==(const Devaddr&, const Devaddr&) = default;
};

/// A point or vector in the plane.
struct Point2d {
  /// [m]
  double px = 0;
  /// [m]
  double py = 0;

  friend bool operator==(const Point2d&, const Point2d&) = default;
};

/// A point or vector in space.
struct Point3d {
  /// [m]
  double px = 0;
  /// [m]
  double py = 0;
  /// [m]
  double pz = 0;

  friend bool operator==(const Point3d&, const Point3d&) = default;
};

/// An orientation in space: rotations about z (yaw), then y (pitch), then x (roll).
struct Orientation3d {
  /// About x. [rad]
  double proll = 0;
  /// About y. [rad]
  double ppitch = 0;
  /// About z. [rad]
  double pyaw = 0;

  friend bool operator==(const Orientation3d&, const Orientation3d&) = default;
};

/// A pose in the plane, or, if the message says so, a velocity with the same three components.
struct Pose2d {
  /// [m]
  double px = 0;
  /// [m]
  double py = 0;
  /// Heading, counter-clockwise from x. [rad]
  double pa = 0;

  friend bool operator==(const Pose2d&, const Pose2d&) = default;
};

/// A pose in space, or, if the message says so, a velocity or acceleration with the same six components.
struct Pose3d {
  /// [m]
  double px = 0;
  /// [m]
  double py = 0;
  /// [m]
  double pz = 0;
  /// About x. [rad]
  double proll = 0;
  /// About y. [rad]
  double ppitch = 0;
  /// About z. [rad]
  double pyaw = 0;

  friend bool operator==(const Pose3d&, const Pose3d&) = default;
};

/// Size of a bounding rectangle.
struct Bbox2d {
  /// Width, along y. [m]
  double sw = 0;
  /// Length, along x. [m]
  double sl = 0;

  friend bool operator==(const Bbox2d&, const Bbox2d&) = default;
};

/// Size of a bounding box.
struct Bbox3d {
  /// Width, along y. [m]
  double sw = 0;
  /// Length, along x. [m]
  double sl = 0;
  /// Height, along z. [m]
  double sh = 0;

  friend bool operator==(const Bbox3d&, const Bbox3d&) = default;
};

/// One entry of a blackboard: a value under a key in a group.
struct BlackboardEntry {
  /// Name of the entry within its group.
  std::string key{};
  /// Name of the group, a namespace of keys.
  std::string group{};
  /// Category of `data`: simple values or types of other interfaces.
  std::uint16_t type = 0;
  /// Exact type of `data`; of simple values: string, integer or floating-point number.
  std::uint16_t subtype = 0;
  /// Bytes of the value, opaque to the blackboard.
  std::vector<std::uint8_t> data{};
  /// Time at which the value was set: whole seconds. [s]
  std::uint32_t timestamp_sec = 0;
  /// Time at which the value was set: microseconds of the second. [us]
  std::uint32_t timestamp_usec = 0;

  friend bool operator==(const BlackboardEntry&, const BlackboardEntry&) = default;
};

/// A line segment.
struct Segment {
  /// x of the start. [m]
  double x0 = 0;
  /// y of the start. [m]
  double y0 = 0;
  /// x of the end. [m]
  double x1 = 0;
  /// y of the end. [m]
  double y1 = 0;

  friend bool operator==(const Segment&, const Segment&) = default;
};

/// An axis-aligned rectangle, given by two corners.
struct Extent2d {
  /// Smallest x. [m]
  double x0 = 0;
  /// Smallest y. [m]
  double y0 = 0;
  /// Largest x. [m]
  double x1 = 0;
  /// Largest y. [m]
  double y1 = 0;

  friend bool operator==(const Extent2d&, const Extent2d&) = default;
};

/// A color with opacity, each component from 0 to 255.
struct Color {
  /// 255 is opaque, 0 invisible.
  std::uint8_t alpha = 0;
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Color&, const Color&) = default;
};

/// A switch.
struct Bool {
  /// 0: off, else on.
  std::uint8_t state = 0;

  friend bool operator==(const Bool&, const Bool&) = default;
};

/// One integer.
struct Uint32 {
  std::uint32_t value = 0;

  friend bool operator==(const Uint32&, const Uint32&) = default;
};

/// The queried message.
struct CapabilitiesReq {
  /// Type of the message, as in a header.
  std::uint32_t type = 0;
  /// Subtype of the message, as in a header.
  std::uint32_t subtype = 0;

  friend bool operator==(const CapabilitiesReq&, const CapabilitiesReq&) = default;
};

/// A named switch.
struct BoolpropReq {
  /// Name of the property, NUL-terminated.
  std::string key{};
  /// 0 false, else true; ignored in a request.
  char value = 0;

  friend bool operator==(const BoolpropReq&, const BoolpropReq&) = default;
};

/// A named integer.
struct IntpropReq {
  /// Name of the property, NUL-terminated.
  std::string key{};
  /// Ignored in a question.
  std::int32_t value = 0;

  friend bool operator==(const IntpropReq&, const IntpropReq&) = default;
};

/// A named number.
struct DblpropReq {
  /// Name of the property, NUL-terminated.
  std::string key{};
  /// In the driver's unit for the property; ignored in a request. [1]
  double value = 0;

  friend bool operator==(const DblpropReq&, const DblpropReq&) = default;
};

/// A named string.
struct StrpropReq {
  /// Name of the property, NUL-terminated.
  std::string key{};
  /// NUL-terminated; ignored in a request.
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
