// Generated from interfaces/062_ranger.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::ranger {

inline constexpr std::uint16_t kCode = 62;

// Subtypes of messages.
inline constexpr std::uint8_t kDataRange = 1;
inline constexpr std::uint8_t kDataRangestamped = 2;
inline constexpr std::uint8_t kDataIntns = 3;
inline constexpr std::uint8_t kDataIntnsstamped = 4;
inline constexpr std::uint8_t kDataGeom = 5;
inline constexpr std::uint8_t kReqGetGeom = 1;
inline constexpr std::uint8_t kReqPower = 2;
inline constexpr std::uint8_t kReqIntns = 3;
inline constexpr std::uint8_t kReqSetConfig = 4;
inline constexpr std::uint8_t kReqGetConfig = 5;

struct Config {
  /// [rad]
  double min_angle = 0;
  /// [rad]
  double max_angle = 0;
  /// [rad]
  double angular_res = 0;
  /// [m]
  double min_range = 0;
  /// [m]
  double max_range = 0;
  /// [m]
  double range_res = 0;
  /// [Hz]
  double frequency = 0;

  friend bool operator==(const Config&, const Config&) = default;
};

struct Geom {
  /// [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// [m, m, m]
  Bbox3d size{};
  /// [frame X_RS]
  std::vector<Pose3d> element_poses{};
  std::vector<Bbox3d> element_sizes{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

struct DataRange {
  /// [m]
  std::vector<double> ranges{};

  friend bool operator==(const DataRange&, const DataRange&) = default;
};

struct DataRangestamped {
  DataRange data{};
  std::uint8_t have_geom = 0;
  Geom geom{};
  std::uint8_t have_config = 0;
  Config config{};

  friend bool operator==(const DataRangestamped&, const DataRangestamped&) = default;
};

struct DataIntns {
  /// [1]
  std::vector<double> intensities{};

  friend bool operator==(const DataIntns&, const DataIntns&) = default;
};

struct DataIntnsstamped {
  DataIntns data{};
  std::uint8_t have_geom = 0;
  Geom geom{};
  std::uint8_t have_config = 0;
  Config config{};

  friend bool operator==(const DataIntnsstamped&, const DataIntnsstamped&) = default;
};

struct PowerConfig {
  std::uint8_t state = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

struct IntnsConfig {
  std::uint8_t state = 0;

  friend bool operator==(const IntnsConfig&, const IntnsConfig&) = default;
};

void read(Reader& in, Config& m);
void write(Writer& out, const Config& m);
void to_json(std::string& out, const Config& m);
void read(Reader& in, Geom& m);
void write(Writer& out, const Geom& m);
void to_json(std::string& out, const Geom& m);
void read(Reader& in, DataRange& m);
void write(Writer& out, const DataRange& m);
void to_json(std::string& out, const DataRange& m);
void read(Reader& in, DataRangestamped& m);
void write(Writer& out, const DataRangestamped& m);
void to_json(std::string& out, const DataRangestamped& m);
void read(Reader& in, DataIntns& m);
void write(Writer& out, const DataIntns& m);
void to_json(std::string& out, const DataIntns& m);
void read(Reader& in, DataIntnsstamped& m);
void write(Writer& out, const DataIntnsstamped& m);
void to_json(std::string& out, const DataIntnsstamped& m);
void read(Reader& in, PowerConfig& m);
void write(Writer& out, const PowerConfig& m);
void to_json(std::string& out, const PowerConfig& m);
void read(Reader& in, IntnsConfig& m);
void write(Writer& out, const IntnsConfig& m);
void to_json(std::string& out, const IntnsConfig& m);

}  // namespace playhouse::wire::ranger
