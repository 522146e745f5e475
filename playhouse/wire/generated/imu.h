// Generated from interfaces/060_imu.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Accelerations, turn rates, magnetic field and orientation.

#include <cstdint>
#include <string>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::imu {

inline constexpr std::uint16_t kCode = 60;

// Subtypes of messages.
/// Pose by integration.
inline constexpr std::uint8_t kDataState = 1;
/// Calibrated readings.
inline constexpr std::uint8_t kDataCalib = 2;
/// Calibrated readings and orientation as a quaternion.
inline constexpr std::uint8_t kDataQuat = 3;
/// Calibrated readings and orientation as angles.
inline constexpr std::uint8_t kDataEuler = 4;
/// Pose, velocity and acceleration.
inline constexpr std::uint8_t kDataFullstate = 5;
/// Selects which data message is sent.
inline constexpr std::uint8_t kReqSetDatatype = 1;
/// Makes the current orientation the reference.
inline constexpr std::uint8_t kReqResetOrientation = 2;
/// Sets the current orientation.
inline constexpr std::uint8_t kReqResetEuler = 3;

/// Pose by integration.
struct DataState {
  /// [frame X_WS, m, m, m, rad, rad, rad]
  Pose3d pose{};

  friend bool operator==(const DataState&, const DataState&) = default;
};

/// Calibrated readings.
struct DataCalib {
  /// [frame a_WS_S, m/s^2]
  float accel_x = 0;
  /// [frame a_WS_S, m/s^2]
  float accel_y = 0;
  /// [frame a_WS_S, m/s^2]
  float accel_z = 0;
  /// [frame v_WS_S, rad/s]
  float gyro_x = 0;
  /// [frame v_WS_S, rad/s]
  float gyro_y = 0;
  /// [frame v_WS_S, rad/s]
  float gyro_z = 0;
  /// Magnetic field, in a driver-specific unit. [frame n_S, 1]
  float magn_x = 0;
  /// [frame n_S, 1]
  float magn_y = 0;
  /// [frame n_S, 1]
  float magn_z = 0;

  friend bool operator==(const DataCalib&, const DataCalib&) = default;
};

/// Calibrated readings and orientation as a quaternion.
struct DataQuat {
  DataCalib calib_data{};
  /// Real part. [frame R_WS, 1]
  float q0 = 0;
  /// [frame R_WS, 1]
  float q1 = 0;
  /// [frame R_WS, 1]
  float q2 = 0;
  /// [frame R_WS, 1]
  float q3 = 0;

  friend bool operator==(const DataQuat&, const DataQuat&) = default;
};

/// Calibrated readings and orientation as angles.
struct DataEuler {
  DataCalib calib_data{};
  /// [frame R_WS, rad]
  Orientation3d orientation{};

  friend bool operator==(const DataEuler&, const DataEuler&) = default;
};

/// Pose, velocity and acceleration.
struct DataFullstate {
  /// [frame X_WS, m, m, m, rad, rad, rad]
  Pose3d pose{};
  /// [frame v_WS_S, m/s, m/s, m/s, rad/s, rad/s, rad/s]
  Pose3d vel{};
  /// [frame a_WS_S, m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2]
  Pose3d acc{};

  friend bool operator==(const DataFullstate&, const DataFullstate&) = default;
};

/// Selected data message.
struct DatatypeConfig {
  /// Its subtype.
  std::uint8_t value = 0;

  friend bool operator==(const DatatypeConfig&, const DatatypeConfig&) = default;
};

/// Quantity that becomes the reference.
struct ResetOrientationConfig {
  /// 0: heading, 1: orientation, 2: driver-specific.
  std::uint32_t value = 0;

  friend bool operator==(const ResetOrientationConfig&, const ResetOrientationConfig&) = default;
};

/// A new orientation.
struct ResetEulerConfig {
  /// Only the angles apply. [frame X_WS, m, m, m, rad, rad, rad]
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
