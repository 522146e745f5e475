// Generated from interfaces/006_laser.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// A scanning range finder. New drivers use the ranger interface.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::laser {

inline constexpr std::uint16_t kCode = 6;

// Subtypes of messages.
/// One scan at equal angles.
inline constexpr std::uint8_t kDataScan = 1;
/// One scan and the pose at which it was measured.
inline constexpr std::uint8_t kDataScanpose = 2;
/// One scan with an angle per beam.
inline constexpr std::uint8_t kDataScanangle = 3;
/// Requests the device's size and pose.
inline constexpr std::uint8_t kReqGetGeom = 1;
/// Sets angles, resolution and rate; the answer has the values in effect.
inline constexpr std::uint8_t kReqSetConfig = 2;
/// Requests angles, resolution and rate.
inline constexpr std::uint8_t kReqGetConfig = 3;
/// Switches the device on or off.
inline constexpr std::uint8_t kReqPower = 4;
/// Requests the serial number.
inline constexpr std::uint8_t kReqGetId = 5;
/// Selects a filter for the ranges.
inline constexpr std::uint8_t kReqSetFilter = 6;

/// Largest number of filter parameters.
inline constexpr std::int32_t kMaxFilterParams = 8;

/// Values of SetFilterConfig.filter_type.
inline constexpr std::int32_t kFilterMedian = 1;
inline constexpr std::int32_t kFilterEdge = 2;
inline constexpr std::int32_t kFilterRange = 3;
inline constexpr std::int32_t kFilterMean = 4;

/// One scan at equal angles.
struct Data {
  /// Of the first beam, counter-clockwise from x. [rad]
  float min_angle = 0;
  /// Of the last beam. [rad]
  float max_angle = 0;
  /// Angle between neighbouring beams. [rad]
  float resolution = 0;
  /// Reported range of a beam without a hit. [m]
  float max_range = 0;
  /// From right to left. [m]
  std::vector<float> ranges{};
  /// Intensity of the echo per beam; empty if the device has none.
  std::vector<std::uint8_t> intensity{};
  /// Increases from scan to scan, by one or more.
  std::uint32_t id = 0;

  friend bool operator==(const Data&, const Data&) = default;
};

/// One scan and the pose at which it was measured.
struct DataScanpose {
  Data scan{};
  /// Of the robot at the time of the scan. [frame X_OR, m, m, rad]
  Pose2d pose{};

  friend bool operator==(const DataScanpose&, const DataScanpose&) = default;
};

/// One scan with an angle per beam.
struct DataScanangle {
  /// Reported range of a beam without a hit. [m]
  float max_range = 0;
  /// One per beam. [m]
  std::vector<float> ranges{};
  /// One per beam, counter-clockwise from x. [rad]
  std::vector<float> angles{};
  /// Intensity of the echo per beam; empty if the device has none.
  std::vector<std::uint8_t> intensity{};
  /// Increases from scan to scan, by one or more.
  std::uint32_t id = 0;

  friend bool operator==(const DataScanangle&, const DataScanangle&) = default;
};

/// The device's size and pose.
struct Geom {
  /// Pose of the device on the robot. [frame X_RS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// Bounding box of the device. [m, m, m]
  Bbox3d size{};

  friend bool operator==(const Geom&, const Geom&) = default;
};

/// Angles, resolution and rate.
struct Config {
  /// Of the first beam. [rad]
  float min_angle = 0;
  /// Of the last beam. [rad]
  float max_angle = 0;
  /// Angle between neighbouring beams. [rad]
  float resolution = 0;
  /// Maximum range. [m]
  float max_range = 0;
  /// Range resolution. [m]
  float range_res = 0;
  /// 1: send intensities, too.
  std::uint8_t intensity = 0;
  /// Scans per second. [Hz]
  float scanning_frequency = 0;

  friend bool operator==(const Config&, const Config&) = default;
};

/// The device's switch.
struct PowerConfig {
  /// 1: on, 0: off.
  std::uint8_t state = 0;

  friend bool operator==(const PowerConfig&, const PowerConfig&) = default;
};

/// A serial number.
struct GetIdConfig {
  /// 0 in the request.
  std::uint32_t serial_number = 0;

  friend bool operator==(const GetIdConfig&, const GetIdConfig&) = default;
};

/// A filter.
struct SetFilterConfig {
  /// Type of filter.
  std::uint8_t filter_type = 0;
  /// Filter-specific. [1] (at most 8)
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
