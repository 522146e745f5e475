// Generated from interfaces/057_wsn.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::wsn {

inline constexpr std::uint16_t kCode = 57;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kCmdDevstate = 1;
inline constexpr std::uint8_t kReqPower = 1;
inline constexpr std::uint8_t kReqDatatype = 2;
inline constexpr std::uint8_t kReqDatafreq = 3;

struct NodeData {
  /// [1]
  float light = 0;
  /// [1]
  float mic = 0;
  /// [1]
  float accel_x = 0;
  /// [1]
  float accel_y = 0;
  /// [1]
  float accel_z = 0;
  /// [1]
  float magn_x = 0;
  /// [1]
  float magn_y = 0;
  /// [1]
  float magn_z = 0;
  /// [1]
  float temperature = 0;
  /// [1]
  float battery = 0;

  friend bool operator==(const NodeData&, const NodeData&) = default;
};

struct Data {
  std::uint32_t node_type = 0;
  std::uint32_t node_id = 0;
  std::uint32_t node_parent_id = 0;
  NodeData data_packet{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct Cmd {
  std::int32_t node_id = 0;
  std::int32_t group_id = 0;
  std::uint32_t device = 0;
  std::uint8_t enable = 0;

  friend bool operator==(const Cmd&, const Cmd&) = default;
};

struct PowerConfig {
  std::int32_t node_id = 0;
  std::int32_t group_id = 0;
  std::uint8_t value = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

struct DatatypeConfig {
  std::uint8_t value = 0;

  friend bool operator==(const DatatypeConfig&, const DatatypeConfig&) = default;
};

struct DatafreqConfig {
  std::int32_t node_id = 0;
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
