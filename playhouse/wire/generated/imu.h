// Generated from interfaces/060_imu.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::imu {

inline constexpr std::uint16_t kCode = 60;

// Subtypes of messages.
inline constexpr std::uint8_t kDataState = 1;
inline constexpr std::uint8_t kDataCalib = 2;
inline constexpr std::uint8_t kDataQuat = 3;
inline constexpr std::uint8_t kDataEuler = 4;
inline constexpr std::uint8_t kDataFullstate = 5;
inline constexpr std::uint8_t kReqSetDatatype = 1;
inline constexpr std::uint8_t kReqResetOrientation = 2;
inline constexpr std::uint8_t kReqResetEuler = 3;

struct DataState {
  /// [frame X_RS]
  Pose3d pose{};

  friend bool operator==(const DataState&, const DataState&) = default;
};

struct DataCalib {
  /// [1]
  float accel_x = 0;
  /// [1]
  float accel_y = 0;
  /// [1]
  float accel_z = 0;
  /// [1]
  float gyro_x = 0;
  /// [1]
  float gyro_y = 0;
  /// [1]
  float gyro_z = 0;
  /// [1]
  float magn_x = 0;
  /// [1]
  float magn_y = 0;
  /// [1]
  float magn_z = 0;

  friend bool operator==(const DataCalib&, const DataCalib&) = default;
};

struct DataQuat {
  DataCalib calib_data{};
  /// [1]
  float q0 = 0;
  /// [1]
  float q1 = 0;
  /// [1]
  float q2 = 0;
  /// [1]
  float q3 = 0;

  friend bool operator==(const DataQuat&, const DataQuat&) = default;
};

struct DataEuler {
  DataCalib calib_data{};
  /// [frame R_WR]
  Orientation3d orientation{};

  friend bool operator==(const DataEuler&, const DataEuler&) = default;
};

struct DataFullstate {
  /// [frame X_RS]
  Pose3d pose{};
  /// [frame X_RS]
  Pose3d vel{};
  /// [frame X_RS]
  Pose3d acc{};

  friend bool operator==(const DataFullstate&, const DataFullstate&) = default;
};

struct DatatypeConfig {
  std::uint8_t value = 0;

  friend bool operator==(const DatatypeConfig&, const DatatypeConfig&) = default;
};

struct ResetOrientationConfig {
  std::uint32_t value = 0;

  friend bool operator==(const ResetOrientationConfig&, const ResetOrientationConfig&) = default;
};

struct ResetEulerConfig {
  /// [frame X_RS]
  Pose3d orientation{};

  friend bool operator==(const ResetEulerConfig&, const ResetEulerConfig&) = default;
};

void read(Reader& in, DataState& m);
void write(Writer& out, const DataState& m);
void to_json(std::string& out, const DataState& m);
void read(Reader& in, DataCalib& m);
void write(Writer& out, const DataCalib& m);
void to_json(std::string& out, const DataCalib& m);
void read(Reader& in, DataQuat& m);
void write(Writer& out, const DataQuat& m);
void to_json(std::string& out, const DataQuat& m);
void read(Reader& in, DataEuler& m);
void write(Writer& out, const DataEuler& m);
void to_json(std::string& out, const DataEuler& m);
void read(Reader& in, DataFullstate& m);
void write(Writer& out, const DataFullstate& m);
void to_json(std::string& out, const DataFullstate& m);
void read(Reader& in, DatatypeConfig& m);
void write(Writer& out, const DatatypeConfig& m);
void to_json(std::string& out, const DatatypeConfig& m);
void read(Reader& in, ResetOrientationConfig& m);
void write(Writer& out, const ResetOrientationConfig& m);
void to_json(std::string& out, const ResetOrientationConfig& m);
void read(Reader& in, ResetEulerConfig& m);
void write(Writer& out, const ResetEulerConfig& m);
void to_json(std::string& out, const ResetEulerConfig& m);

}  // namespace playhouse::wire::imu
