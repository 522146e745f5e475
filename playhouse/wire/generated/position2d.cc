// Generated from interfaces/004_position2d.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/position2d.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::position2d {

void read(Reader& in, Data& m) {
  read(in, m.pos);
  read(in, m.vel);
  in.read(m.stall);
}

void write(Writer& out, const Data& m) {
  write(out, m.pos);
  write(out, m.vel);
  out.write(m.stall);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "pos");
  to_json(out, m.pos);
  json_key(out, ',', "vel");
  to_json(out, m.vel);
  json_key(out, ',', "stall");
  json_value(out, m.stall);
  out += '}';
}

void read(Reader& in, CmdVel& m) {
  read(in, m.vel);
  in.read(m.state);
}

void write(Writer& out, const CmdVel& m) {
  write(out, m.vel);
  out.write(m.state);
}

void to_json(std::string& out, const CmdVel& m) {
  json_key(out, '{', "vel");
  to_json(out, m.vel);
  json_key(out, ',', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, CmdPos& m) {
  read(in, m.pos);
  read(in, m.vel);
  in.read(m.state);
}

void write(Writer& out, const CmdPos& m) {
  write(out, m.pos);
  write(out, m.vel);
  out.write(m.state);
}

void to_json(std::string& out, const CmdPos& m) {
  json_key(out, '{', "pos");
  to_json(out, m.pos);
  json_key(out, ',', "vel");
  to_json(out, m.vel);
  json_key(out, ',', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, CmdCar& m) {
  in.read(m.velocity);
  in.read(m.angle);
}

void write(Writer& out, const CmdCar& m) {
  out.write(m.velocity);
  out.write(m.angle);
}

void to_json(std::string& out, const CmdCar& m) {
  json_key(out, '{', "velocity");
  json_value(out, m.velocity);
  json_key(out, ',', "angle");
  json_value(out, m.angle);
  out += '}';
}

void read(Reader& in, CmdVelHead& m) {
  in.read(m.velocity);
  in.read(m.angle);
}

void write(Writer& out, const CmdVelHead& m) {
  out.write(m.velocity);
  out.write(m.angle);
}

void to_json(std::string& out, const CmdVelHead& m) {
  json_key(out, '{', "velocity");
  json_value(out, m.velocity);
  json_key(out, ',', "angle");
  json_value(out, m.angle);
  out += '}';
}

void read(Reader& in, Geom& m) {
  read(in, m.pose);
  read(in, m.size);
}

void write(Writer& out, const Geom& m) {
  write(out, m.pose);
  write(out, m.size);
}

void to_json(std::string& out, const Geom& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "size");
  to_json(out, m.size);
  out += '}';
}

void read(Reader& in, PowerConfig& m) {
  in.read(m.state);
}

void write(Writer& out, const PowerConfig& m) {
  out.write(m.state);
}

void to_json(std::string& out, const PowerConfig& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, VelocityModeConfig& m) {
  in.read(m.value);
}

void write(Writer& out, const VelocityModeConfig& m) {
  out.write(m.value);
}

void to_json(std::string& out, const VelocityModeConfig& m) {
  json_key(out, '{', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, PositionModeReq& m) {
  in.read(m.state);
}

void write(Writer& out, const PositionModeReq& m) {
  out.write(m.state);
}

void to_json(std::string& out, const PositionModeReq& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, SetOdomReq& m) {
  read(in, m.pose);
}

void write(Writer& out, const SetOdomReq& m) {
  write(out, m.pose);
}

void to_json(std::string& out, const SetOdomReq& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  out += '}';
}

void read(Reader& in, SpeedPidReq& m) {
  in.read(m.kp);
  in.read(m.ki);
  in.read(m.kd);
}

void write(Writer& out, const SpeedPidReq& m) {
  out.write(m.kp);
  out.write(m.ki);
  out.write(m.kd);
}

void to_json(std::string& out, const SpeedPidReq& m) {
  json_key(out, '{', "kp");
  json_value(out, m.kp);
  json_key(out, ',', "ki");
  json_value(out, m.ki);
  json_key(out, ',', "kd");
  json_value(out, m.kd);
  out += '}';
}

void read(Reader& in, PositionPidReq& m) {
  in.read(m.kp);
  in.read(m.ki);
  in.read(m.kd);
}

void write(Writer& out, const PositionPidReq& m) {
  out.write(m.kp);
  out.write(m.ki);
  out.write(m.kd);
}

void to_json(std::string& out, const PositionPidReq& m) {
  json_key(out, '{', "kp");
  json_value(out, m.kp);
  json_key(out, ',', "ki");
  json_value(out, m.ki);
  json_key(out, ',', "kd");
  json_value(out, m.kd);
  out += '}';
}

void read(Reader& in, SpeedProfReq& m) {
  in.read(m.speed);
  in.read(m.acc);
}

void write(Writer& out, const SpeedProfReq& m) {
  out.write(m.speed);
  out.write(m.acc);
}

void to_json(std::string& out, const SpeedProfReq& m) {
  json_key(out, '{', "speed");
  json_value(out, m.speed);
  json_key(out, ',', "acc");
  json_value(out, m.acc);
  out += '}';
}

const MessageDef kRows[15] = {
    {4, MessageType::kData, kDataState, "position2d.data.state", "position2d::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {4, MessageType::kData, kDataGeom, "position2d.data.geom", "position2d::Geom", true, Policy::kLatest,
     check_required<Geom>, reencode<Geom>, body_to_json<Geom>},
    {4, MessageType::kCmd, kCmdVel, "position2d.cmd.vel", "position2d::CmdVel", true, Policy::kLatest,
     check_required<CmdVel>, reencode<CmdVel>, body_to_json<CmdVel>},
    {4, MessageType::kCmd, kCmdPos, "position2d.cmd.pos", "position2d::CmdPos", true, Policy::kLatest,
     check_required<CmdPos>, reencode<CmdPos>, body_to_json<CmdPos>},
    {4, MessageType::kCmd, kCmdCar, "position2d.cmd.car", "position2d::CmdCar", true, Policy::kLatest,
     check_required<CmdCar>, reencode<CmdCar>, body_to_json<CmdCar>},
    {4, MessageType::kCmd, kCmdVelHead, "position2d.cmd.vel_head", "position2d::CmdVelHead", true, Policy::kLatest,
     check_required<CmdVelHead>, reencode<CmdVelHead>, body_to_json<CmdVelHead>},
    {4, MessageType::kReq, kReqGetGeom, "position2d.req.get_geom", "position2d::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
    {4, MessageType::kReq, kReqMotorPower, "position2d.req.motor_power", "position2d::PowerConfig", true, Policy::kNone,
     check_optional<PowerConfig>, reencode<PowerConfig>, body_to_json<PowerConfig>},
    {4, MessageType::kReq, kReqVelocityMode, "position2d.req.velocity_mode", "position2d::VelocityModeConfig", true, Policy::kNone,
     check_optional<VelocityModeConfig>, reencode<VelocityModeConfig>, body_to_json<VelocityModeConfig>},
    {4, MessageType::kReq, kReqPositionMode, "position2d.req.position_mode", "position2d::PositionModeReq", true, Policy::kNone,
     check_optional<PositionModeReq>, reencode<PositionModeReq>, body_to_json<PositionModeReq>},
    {4, MessageType::kReq, kReqSetOdom, "position2d.req.set_odom", "position2d::SetOdomReq", true, Policy::kNone,
     check_optional<SetOdomReq>, reencode<SetOdomReq>, body_to_json<SetOdomReq>},
    {4, MessageType::kReq, kReqResetOdom, "position2d.req.reset_odom", "", false, Policy::kNone,
     check_nothing, reencode_nothing, nothing_to_json},
    {4, MessageType::kReq, kReqSpeedPid, "position2d.req.speed_pid", "position2d::SpeedPidReq", true, Policy::kNone,
     check_optional<SpeedPidReq>, reencode<SpeedPidReq>, body_to_json<SpeedPidReq>},
    {4, MessageType::kReq, kReqPositionPid, "position2d.req.position_pid", "position2d::PositionPidReq", true, Policy::kNone,
     check_optional<PositionPidReq>, reencode<PositionPidReq>, body_to_json<PositionPidReq>},
    {4, MessageType::kReq, kReqSpeedProf, "position2d.req.speed_prof", "position2d::SpeedProfReq", true, Policy::kNone,
     check_optional<SpeedProfReq>, reencode<SpeedProfReq>, body_to_json<SpeedProfReq>},
};

}  // namespace playhouse::wire::position2d
