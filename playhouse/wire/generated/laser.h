// Generated from interfaces/006_laser.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::laser {

inline constexpr std::uint16_t kCode = 6;

// Subtypes of messages.
inline constexpr std::uint8_t kDataScan = 1;
inline constexpr std::uint8_t kDataScanpose = 2;
inline constexpr std::uint8_t kDataScanangle = 3;
inline constexpr std::uint8_t kReqGetGeom = 1;
inline constexpr std::uint8_t kReqSetConfig = 2;
inline constexpr std::uint8_t kReqGetConfig = 3;
inline constexpr std::uint8_t kReqPower = 4;
inline constexpr std::uint8_t kReqGetId = 5;
inline constexpr std::uint8_t kReqSetFilter = 6;

inline constexpr std::int32_t kMaxFilterParams = 8;
inline constexpr std::int32_t kFilterMedian = 1;
inline constexpr std::int32_t kFilterEdge = 2;
inline constexpr std::int32_t kFilterRange = 3;
inline constexpr std::int32_t kFilterMean = 4;

struct Data {
  /// [rad]
  float min_angle = 0;
  /// [rad]
  float max_angle = 0;
  /// [rad]
  float resolution = 0;
  /// [m]
  float max_range = 0;
  /// [m]
  std::vector<float> ranges{};
  std::vector<std::uint8_t> intensity{};
  std::uint32_t id = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

struct DataScanpose {
  Data scan{};
  /// [frame X_RS]
  Pose2d pose{};

  friend bool operator==(const DataScanpose&, const DataScanpose&) = default;
};

struct DataScanangle {
  /// [m]
  float max_range = 0;
  /// [m]
  std::vector<float> ranges{};
  /// [rad]
  std::vector<float> angles{};
  std::vector<std::uint8_t> intensity{};
  std::uint32_t id = 0;

  friend bool operator==(const DataScanangle&, const DataScanangle&) = default;
};

struct Geom {
  /// [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// [m, m, m]
  Bbox3d size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

struct Config {
  /// [rad]
  float min_angle = 0;
  /// [rad]
  float max_angle = 0;
  /// [rad]
  float resolution = 0;
  /// [m]
  float max_range = 0;
  /// [m]
  float range_res = 0;
  std::uint8_t intensity = 0;
  /// [Hz]
  float scanning_frequency = 0;

  friend bool operator==(const Config&, const Config&) = default;
};

struct PowerConfig {
  std::uint8_t state = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

struct GetIdConfig {
  std::uint32_t serial_number = 0;

  friend bool operator==(const GetIdConfig&, const GetIdConfig&) = default;
};

struct SetFilterConfig {
  std::uint8_t filter_type = 0;
  /// [1] (at most 8)
  std::vector<float> parameters{};

  friend bool operator==(const SetFilterConfig&, const SetFilterConfig&) = default;
};

void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, DataScanpose& m);
void write(Writer& out, const DataScanpose& m);
void to_json(std::string& out, const DataScanpose& m);
void read(Reader& in, DataScanangle& m);
void write(Writer& out, const DataScanangle& m);
void to_json(std::string& out, const DataScanangle& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);
void read(Reader& in, Config& m);
void write(Writer& out, const Config& m);
void to_json(std::string& out, const Config& m);
void read(Reader& in, PowerConfig& m);
void write(Writer& out, const PowerConfig& m);
void to_json(std::string& out, const PowerConfig& m);
void read(Reader& in, GetIdConfig& m);
void write(Writer& out, const GetIdConfig& m);
void to_json(std::string& out, const GetIdConfig& m);
void read(Reader& in, SetFilterConfig& m);
void write(Writer& out, const SetFilterConfig& m);
void to_json(std::string& out, const SetFilterConfig& m);

}  // namespace playhouse::wire::laser
