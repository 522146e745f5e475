// Generated from interfaces/062_ranger.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Range finders of any type: lasers, sonars, infrared, single or in arrays.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::ranger {

inline constexpr std::uint16_t kCode = 62;

// Subtypes of messages.
/// Ranges.
inline constexpr std::uint8_t kDataRange = 1;
/// Ranges with the geometry and configuration of the measurement.
inline constexpr std::uint8_t kDataRangestamped = 2;
/// Intensities.
inline constexpr std::uint8_t kDataIntns = 3;
/// Intensities with the geometry and configuration of the measurement.
inline constexpr std::uint8_t kDataIntnsstamped = 4;
/// Size and pose, sent on change.
inline constexpr std::uint8_t kDataGeom = 5;
/// Requests size and pose.
inline constexpr std::uint8_t kReqGetGeom = 1;
/// Switches the device on or off.
inline constexpr std::uint8_t kReqPower = 2;
/// Switches intensities on or off.
inline constexpr std::uint8_t kReqIntns = 3;
/// Sets angles, ranges and rate; the answer has the values in effect.
inline constexpr std::uint8_t kReqSetConfig = 4;
/// Requests angles, ranges and rate.
inline constexpr std::uint8_t kReqGetConfig = 5;

/// Angles, ranges and rate.
struct Config {
  /// Of the first beam, counter-clockwise from x. [rad]
  double min_angle = 0;
  /// Of the last beam. [rad]
  double max_angle = 0;
  /// Angle between neighbouring beams. [rad]
  double angular_res = 0;
  /// Minimum range. [m]
  double min_range = 0;
  /// Maximum range, and reported range of a beam without a hit. [m]
  double max_range = 0;
  /// Range resolution. [m]
  double range_res = 0;
  /// Scans per second. [Hz]
  double frequency = 0;

  friend bool operator==(const Config&, const Config&) = default;
};

/// Size and pose of the device and its elements.
struct Geom {
  /// Pose of the device on the robot. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Bounding box of the device. [m, m, m]
  Bbox3d size{};
  /// One per element; x points along its beam, or along the middle of its scan. [frame X_SE, m, m, m, rad,
  /// rad, rad]
  std::vector<Pose3d> element_poses{};
  /// One per element. [m, m, m]
  std::vector<Bbox3d> element_sizes{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// Ranges.
struct DataRange {
  /// Beam by beam from right to left, element by element. [m]
  std::vector<double> ranges{};

  friend bool operator==(const DataRange&, const DataRange&) = default;
};

/// Ranges with geometry and configuration.
struct DataRangestamped {
  DataRange data{};
  /// 1 if `geom` is valid.
  std::uint8_t have_geom = 0;
  Geom geom{};
  /// 1 if `config` is valid.
  std::uint8_t have_config = 0;
  Config config{};

  friend bool operator==(const DataRangestamped&, const DataRangestamped&) = default;
};

/// Intensities.
struct DataIntns {
  /// In the order of the ranges; driver-specific scale. [1]
  std::vector<double> intensities{};

  friend bool operator==(const DataIntns&, const DataIntns&) = default;
};

/// Intensities with geometry and configuration.
struct DataIntnsstamped {
  DataIntns data{};
  /// 1 if `geom` is valid.
  std::uint8_t have_geom = 0;
  Geom geom{};
  /// 1 if `config` is valid.
  std::uint8_t have_config = 0;
  Config config{};

  friend bool operator==(const DataIntnsstamped&, const DataIntnsstamped&) = default;
};

/// The device's switch.
struct PowerConfig {
  /// 1: on, 0: off.
  std::uint8_t state = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

/// The switch of intensities.
struct IntnsConfig {
  /// 1: on, 0: off.
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
