// Generated from interfaces/066_coopobject.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Cooperating objects: fixed and moving sensor nodes and robots that report to each other.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::coopobject {

inline constexpr std::uint16_t kCode = 66;

// Subtypes of messages.
/// A node is alive.
inline constexpr std::uint8_t kDataHealth = 1;
/// Signal strength received by a node.
inline constexpr std::uint8_t kDataRssi = 2;
/// Readings of a node.
inline constexpr std::uint8_t kDataSensor = 3;
/// Readings of a node that crossed a threshold.
inline constexpr std::uint8_t kDataAlarm = 4;
/// Bytes from a node.
inline constexpr std::uint8_t kDataUserdefined = 5;
/// A request of a node.
inline constexpr std::uint8_t kDataRequest = 6;
/// A command of a node.
inline constexpr std::uint8_t kDataCommand = 7;
/// Position of a node.
inline constexpr std::uint8_t kDataPosition = 8;
/// Sends a command to a node.
inline constexpr std::uint8_t kCmdStandard = 1;
/// Sends bytes to a node.
inline constexpr std::uint8_t kCmdData = 2;
/// Sends the position of a node to a node.
inline constexpr std::uint8_t kCmdPosition = 3;
/// Sends a request to a node.
inline constexpr std::uint8_t kReqStandard = 1;

/// Values of Header.origin.
inline constexpr std::int32_t kOriginStaticbase = 0;
inline constexpr std::int32_t kOriginMobilebase = 1;
inline constexpr std::int32_t kOriginMote = 2;
inline constexpr std::int32_t kOriginRobot = 3;

/// Types of messages between nodes.
inline constexpr std::int32_t kMsgNone = -1;
inline constexpr std::int32_t kMsgHealth = 0;
inline constexpr std::int32_t kMsgPosition = 1;
inline constexpr std::int32_t kMsgRssi = 2;
inline constexpr std::int32_t kMsgSensor = 3;
inline constexpr std::int32_t kMsgAlarm = 4;
inline constexpr std::int32_t kMsgRequest = 5;
inline constexpr std::int32_t kMsgCommand = 6;

/// Values of Sensor.type.
inline constexpr std::int32_t kTemperature = 0;
inline constexpr std::int32_t kHumidity = 1;
inline constexpr std::int32_t kPressure = 2;
inline constexpr std::int32_t kLight1 = 3;
inline constexpr std::int32_t kLight2 = 4;
inline constexpr std::int32_t kAccelX = 5;
inline constexpr std::int32_t kAccelY = 6;
inline constexpr std::int32_t kAccelZ = 7;
inline constexpr std::int32_t kMagnetometerX = 8;
inline constexpr std::int32_t kMagnetometerY = 9;
inline constexpr std::int32_t kMagnetometerZ = 10;
inline constexpr std::int32_t kCompass = 11;
inline constexpr std::int32_t kCo = 12;
inline constexpr std::int32_t kCo2 = 13;
inline constexpr std::int32_t kH2 = 14;
inline constexpr std::int32_t kSmoke = 15;
inline constexpr std::int32_t kOptswitch = 16;

/// Id of the node.
struct Header {
  /// Type of node.
  std::uint8_t origin = 0;
  std::uint16_t id = 0;
  /// Node that relayed the message.
  std::uint16_t parent_id = 0;

  friend bool operator==(const Header&, const Header&) = default;
};

/// Radio signal strength.
struct Rssi {
  Header header{};
  /// Node that sent the signal.
  std::uint16_t sender_id = 0;
  /// As the radio reports it.
  std::uint16_t rssi = 0;
  /// Counter of measurements.
  std::uint16_t stamp = 0;
  /// Clock of the node: upper half.
  std::uint32_t nodeTimeHigh = 0;
  /// Clock of the node: lower half.
  std::uint32_t nodeTimeLow = 0;
  /// Position of the receiver. [frame p_WS, m]
  float x = 0;
  /// [frame p_WS, m]
  float y = 0;
  /// [frame p_WS, m]
  float z = 0;

  friend bool operator==(const Rssi&, const Rssi&) = default;
};

/// Position of a node.
struct Position {
  Header header{};
  /// [frame p_WS, m]
  float x = 0;
  /// [frame p_WS, m]
  float y = 0;
  /// [frame p_WS, m]
  float z = 0;
  /// Driver-specific.
  std::uint8_t status = 0;

  friend bool operator==(const Position&, const Position&) = default;
};

/// One reading.
struct Sensor {
  /// Measured quantity.
  std::uint8_t type = 0;
  /// As the sensor reports it.
  std::int16_t value = 0;

  friend bool operator==(const Sensor&, const Sensor&) = default;
};

/// Readings of a node.
struct DataSensor {
  Header header{};
  std::vector<Sensor> data{};

  friend bool operator==(const DataSensor&, const DataSensor&) = default;
};

/// Bytes from or to a node.
struct DataUserdefined {
  Header header{};
  /// User-specific.
  std::uint8_t type = 0;
  std::vector<std::uint8_t> data{};

  friend bool operator==(const DataUserdefined&, const DataUserdefined&) = default;
};

/// A request.
struct Req {
  Header header{};
  /// Which.
  std::uint8_t request = 0;
  /// Request-specific.
  std::vector<std::uint8_t> parameters{};

  friend bool operator==(const Req&, const Req&) = default;
};

/// A command.
struct Cmd {
  Header header{};
  /// Which.
  std::uint8_t command = 0;
  /// Command-specific.
  std::vector<std::uint8_t> parameters{};

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

void read(Reader& in, Header& m);
void write(Writer& out, const Header& m);
void to_json(std::string& out, const Header& m);
void read(Reader& in, Rssi& m);
void write(Writer& out, const Rssi& m);
void to_json(std::string& out, const Rssi& m);
void read(Reader& in, Position& m);
void write(Writer& out, const Position& m);
void to_json(std::string& out, const Position& m);
void read(Reader& in, Sensor& m);
void write(Writer& out, const Sensor& m);
void to_json(std::string& out, const Sensor& m);
void read(Reader& in, DataSensor& m);
void write(Writer& out, const DataSensor& m);
void to_json(std::string& out, const DataSensor& m);
void read(Reader& in, DataUserdefined& m);
void write(Writer& out, const DataUserdefined& m);
void to_json(std::string& out, const DataUserdefined& m);
void read(Reader& in, Req& m);
void write(Writer& out, const Req& m);
void to_json(std::string& out, const Req& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);

}  // namespace playhouse::wire::coopobject
