// Generated from interfaces/060_imu.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/imu.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::imu {

void read(Reader& in, DataState& m) {
  read(in, m.pose);
}

void write(Writer& out, const DataState& m) {
  write(out, m.pose);
}

void to_json(std::string& out, const DataState& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  out += '}';
}

void read(Reader& in, DataCalib& m) {
  in.read(m.accel_x);
  in.read(m.accel_y);
  in.read(m.accel_z);
  in.read(m.gyro_x);
  in.read(m.gyro_y);
  in.read(m.gyro_z);
  in.read(m.magn_x);
  in.read(m.magn_y);
  in.read(m.magn_z);
}

void write(Writer& out, const DataCalib& m) {
  out.write(m.accel_x);
  out.write(m.accel_y);
  out.write(m.accel_z);
  out.write(m.gyro_x);
  out.write(m.gyro_y);
  out.write(m.gyro_z);
  out.write(m.magn_x);
  out.write(m.magn_y);
  out.write(m.magn_z);
}

void to_json(std::string& out, const DataCalib& m) {
  json_key(out, '{', "accel_x");
  json_value(out, m.accel_x);
  json_key(out, ',', "accel_y");
  json_value(out, m.accel_y);
  json_key(out, ',', "accel_z");
  json_value(out, m.accel_z);
  json_key(out, ',', "gyro_x");
  json_value(out, m.gyro_x);
  json_key(out, ',', "gyro_y");
  json_value(out, m.gyro_y);
  json_key(out, ',', "gyro_z");
  json_value(out, m.gyro_z);
  json_key(out, ',', "magn_x");
  json_value(out, m.magn_x);
  json_key(out, ',', "magn_y");
  json_value(out, m.magn_y);
  json_key(out, ',', "magn_z");
  json_value(out, m.magn_z);
  out += '}';
}

void read(Reader& in, DataQuat& m) {
  read(in, m.calib_data);
  in.read(m.q0);
  in.read(m.q1);
  in.read(m.q2);
  in.read(m.q3);
}

void write(Writer& out, const DataQuat& m) {
  write(out, m.calib_data);
  out.write(m.q0);
  out.write(m.q1);
  out.write(m.q2);
  out.write(m.q3);
}

void to_json(std::string& out, const DataQuat& m) {
  json_key(out, '{', "calib_data");
  to_json(out, m.calib_data);
  json_key(out, ',', "q0");
  json_value(out, m.q0);
  json_key(out, ',', "q1");
  json_value(out, m.q1);
  json_key(out, ',', "q2");
  json_value(out, m.q2);
  json_key(out, ',', "q3");
  json_value(out, m.q3);
  out += '}';
}

void read(Reader& in, DataEuler& m) {
  read(in, m.calib_data);
  read(in, m.orientation);
}

void write(Writer& out, const DataEuler& m) {
  write(out, m.calib_data);
  write(out, m.orientation);
}

void to_json(std::string& out, const DataEuler& m) {
  json_key(out, '{', "calib_data");
  to_json(out, m.calib_data);
  json_key(out, ',', "orientation");
  to_json(out, m.orientation);
  out += '}';
}

void read(Reader& in, DataFullstate& m) {
  read(in, m.pose);
  read(in, m.vel);
  read(in, m.acc);
}

void write(Writer& out, const DataFullstate& m) {
  write(out, m.pose);
  write(out, m.vel);
  write(out, m.acc);
}

void to_json(std::string& out, const DataFullstate& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "vel");
  to_json(out, m.vel);
  json_key(out, ',', "acc");
  to_json(out, m.acc);
  out += '}';
}

void read(Reader& in, DatatypeConfig& m) {
  in.read(m.value);
}

void write(Writer& out, const DatatypeConfig& m) {
  out.write(m.value);
}

void to_json(std::string& out, const DatatypeConfig& m) {
  json_key(out, '{', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, ResetOrientationConfig& m) {
  in.read(m.value);
}

void write(Writer& out, const ResetOrientationConfig& m) {
  out.write(m.value);
}

void to_json(std::string& out, const ResetOrientationConfig& m) {
  json_key(out, '{', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, ResetEulerConfig& m) {
  read(in, m.orientation);
}

void write(Writer& out, const ResetEulerConfig& m) {
  write(out, m.orientation);
}

void to_json(std::string& out, const ResetEulerConfig& m) {
  json_key(out, '{', "orientation");
  to_json(out, m.orientation);
  out += '}';
}

const MessageDef kRows[8] = {
    {60, MessageType::kData, kDataState, "imu.data.state", "imu::DataState", true, Policy::kLatest,
     check_required<DataState>, reencode<DataState>, body_to_json<DataState>},
    {60, MessageType::kData, kDataCalib, "imu.data.calib", "imu::DataCalib", true, Policy::kLatest,
     check_required<DataCalib>, reencode<DataCalib>, body_to_json<DataCalib>},
    {60, MessageType::kData, kDataQuat, "imu.data.quat", "imu::DataQuat", true, Policy::kLatest,
     check_required<DataQuat>, reencode<DataQuat>, body_to_json<DataQuat>},
    {60, MessageType::kData, kDataEuler, "imu.data.euler", "imu::DataEuler", true, Policy::kLatest,
     check_required<DataEuler>, reencode<DataEuler>, body_to_json<DataEuler>},
    {60, MessageType::kData, kDataFullstate, "imu.data.fullstate", "imu::DataFullstate", true, Policy::kLatest,
     check_required<DataFullstate>, reencode<DataFullstate>, body_to_json<DataFullstate>},
    {60, MessageType::kReq, kReqSetDatatype, "imu.req.set_datatype", "imu::DatatypeConfig", true, Policy::kNone,
     check_optional<DatatypeConfig>, reencode<DatatypeConfig>, body_to_json<DatatypeConfig>},
    {60, MessageType::kReq, kReqResetOrientation, "imu.req.reset_orientation", "imu::ResetOrientationConfig", true, Policy::kNone,
     check_optional<ResetOrientationConfig>, reencode<ResetOrientationConfig>, body_to_json<ResetOrientationConfig>},
    {60, MessageType::kReq, kReqResetEuler, "imu.req.reset_euler", "imu::ResetEulerConfig", true, Policy::kNone,
     check_optional<ResetEulerConfig>, reencode<ResetEulerConfig>, body_to_json<ResetEulerConfig>},
};

}  // namespace playhouse::wire::imu
