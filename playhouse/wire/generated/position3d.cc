// Generated from interfaces/030_position3d.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/position3d.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::position3d {

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

void read(Reader& in, PositionModeReq& m) {
  in.read(m.value);
}

void write(Writer& out, const PositionModeReq& m) {
  out.write(m.value);
}

void to_json(std::string& out, const PositionModeReq& m) {
  json_key(out, '{', "value");
  json_value(out, m.value);
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

void read(Reader& in, SetOdomReq& m) {
  read(in, m.pos);
}

void write(Writer& out, const SetOdomReq& m) {
  write(out, m.pos);
}

void to_json(std::string& out, const SetOdomReq& m) {
  json_key(out, '{', "pos");
  to_json(out, m.pos);
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

const MessageDef kRows[13] = {
    {30, MessageType::kData, kDataState, "position3d.data.state", "position3d::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {30, MessageType::kData, kDataGeometry, "position3d.data.geometry", "position3d::Geom", true, Policy::kLatest,
     check_required<Geom>, reencode<Geom>, body_to_json<Geom>},
    {30, MessageType::kCmd, kCmdSetVel, "position3d.cmd.set_vel", "position3d::CmdVel", true, Policy::kLatest,
     check_required<CmdVel>, reencode<CmdVel>, body_to_json<CmdVel>},
    {30, MessageType::kCmd, kCmdSetPos, "position3d.cmd.set_pos", "position3d::CmdPos", true, Policy::kLatest,
     check_required<CmdPos>, reencode<CmdPos>, body_to_json<CmdPos>},
    {30, MessageType::kReq, kReqGetGeom, "position3d.req.get_geom", "position3d::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
    {30, MessageType::kReq, kReqMotorPower, "position3d.req.motor_power", "position3d::PowerConfig", true, Policy::kNone,
     check_optional<PowerConfig>, reencode<PowerConfig>, body_to_json<PowerConfig>},
    {30, MessageType::kReq, kReqVelocityMode, "position3d.req.velocity_mode", "position3d::VelocityModeConfig", true, Policy::kNone,
     check_optional<VelocityModeConfig>, reencode<VelocityModeConfig>, body_to_json<VelocityModeConfig>},
    {30, MessageType::kReq, kReqPositionMode, "position3d.req.position_mode", "position3d::PositionModeReq", true, Policy::kNone,
     check_optional<PositionModeReq>, reencode<PositionModeReq>, body_to_json<PositionModeReq>},
    {30, MessageType::kReq, kReqResetOdom, "position3d.req.reset_odom", "", false, Policy::kNone,
     check_nothing, reencode_nothing, nothing_to_json},
    {30, MessageType::kReq, kReqSetOdom, "position3d.req.set_odom", "position3d::SetOdomReq", true, Policy::kNone,
     check_optional<SetOdomReq>, reencode<SetOdomReq>, body_to_json<SetOdomReq>},
    {30, MessageType::kReq, kReqSpeedPid, "position3d.req.speed_pid", "position3d::SpeedPidReq", true, Policy::kNone,
     check_optional<SpeedPidReq>, reencode<SpeedPidReq>, body_to_json<SpeedPidReq>},
    {30, MessageType::kReq, kReqPositionPid, "position3d.req.position_pid", "position3d::PositionPidReq", true, Policy::kNone,
     check_optional<PositionPidReq>, reencode<PositionPidReq>, body_to_json<PositionPidReq>},
    {30, MessageType::kReq, kReqSpeedProf, "position3d.req.speed_prof", "position3d::SpeedProfReq", true, Policy::kNone,
     check_optional<SpeedProfReq>, reencode<SpeedProfReq>, body_to_json<SpeedProfReq>},
};

}  // namespace playhouse::wire::position3d
