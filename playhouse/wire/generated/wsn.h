// Generated from interfaces/057_wsn.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A network of wireless sensor nodes.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::wsn {

inline constexpr std::uint16_t kCode = 57;

// Subtypes of messages.
/// Readings of one node.
inline constexpr std::uint8_t kDataState = 1;
/// Switches an actuator of a node.
inline constexpr std::uint8_t kCmdDevstate = 1;
/// Puts nodes to sleep or wakes them.
inline constexpr std::uint8_t kReqPower = 1;
/// Selects between raw and converted readings.
inline constexpr std::uint8_t kReqDatatype = 2;
/// Sets the reporting rate of nodes.
inline constexpr std::uint8_t kReqDatafreq = 3;

/// Readings, raw or converted as selected by DATATYPE.
struct NodeData {
  /// [1 or lx]
  float light = 0;
  /// [1]
  float mic = 0;
  /// [1 or m/s^2]
  float accel_x = 0;
  /// [1 or m/s^2]
  float accel_y = 0;
  /// [1 or m/s^2]
  float accel_z = 0;
  /// [1 or G]
  float magn_x = 0;
  /// [1 or G]
  float magn_y = 0;
  /// [1 or G]
  float magn_z = 0;
  /// [1 or degC]
  float temperature = 0;
  /// [1 or V]
  float battery = 0;

  friend bool operator==(const NodeData&, const NodeData&) = default;
};

/// Readings of one node.
struct Data {
  /// Type of node.
  std::uint32_t node_type = 0;
  /// Id of the node.
  std::uint32_t node_id = 0;
  /// Node that relayed the readings.
  std::uint32_t node_parent_id = 0;
  NodeData data_packet{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// Switch of an actuator of a node.
struct Cmd {
  /// Id of the node; -1: all.
  std::int32_t node_id = 0;
  /// Group of the node; -1: all.
  std::int32_t group_id = 0;
  /// Actuator, such as a light or a buzzer.
  std::uint32_t device = 0;
  /// 1: on, 0: off.
  std::uint8_t enable = 0;

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

/// Sleep mode of nodes.
struct PowerConfig {
  /// Id of the node; -1: all.
  std::int32_t node_id = 0;
  /// Group of the node; -1: all.
  std::int32_t group_id = 0;
  /// 0: asleep, 1: awake, 2: driver-specific.
  std::uint8_t value = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

/// Format of readings.
struct DatatypeConfig {
  /// 0: raw, 1: converted.
  std::uint8_t value = 0;

  friend bool operator==(const DatatypeConfig&, const DatatypeConfig&) = default;
};

/// Rate of reports.
struct DatafreqConfig {
  /// Id of the node; -1: all.
  std::int32_t node_id = 0;
  /// Group of the node; -1: all.
  std::int32_t group_id = 0;
  /// [Hz]
  double frequency = 0;

  friend bool operator==(const DatafreqConfig&, const DatafreqConfig&) = default;
};

void read(Reader& in, NodeData& m);
void write(Writer& out, const NodeData& m);
void to_json(std::string& out, const NodeData& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, Cmd& m);
void write(Writer& out, const Cmd& m);
void to_json(std::string& out, const Cmd& m);
void read(Reader& in, PowerConfig& m);
void write(Writer& out, const PowerConfig& m);
void to_json(std::string& out, const PowerConfig& m);
void read(Reader& in, DatatypeConfig& m);
void write(Writer& out, const DatatypeConfig& m);
void to_json(std::string& out, const DatatypeConfig& m);
void read(Reader& in, DatafreqConfig& m);
void write(Writer& out, const DatafreqConfig& m);
void to_json(std::string& out, const DatafreqConfig& m);

}  // namespace playhouse::wire::wsn
