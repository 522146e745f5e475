// Generated from interfaces/052_position1d.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/position1d.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::position1d {

void read(Reader& in, Data& m) {
  in.read(m.pos);
  in.read(m.vel);
  in.read(m.stall);
  in.read(m.status);
}

void write(Writer& out, const Data& m) {
  out.write(m.pos);
  out.write(m.vel);
  out.write(m.stall);
  out.write(m.status);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "pos");
  json_value(out, m.pos);
  json_key(out, ',', "vel");
  json_value(out, m.vel);
  json_key(out, ',', "stall");
  json_value(out, m.stall);
  json_key(out, ',', "status");
  json_value(out, m.status);
  out += '}';
}

void read(Reader& in, CmdVel& m) {
  in.read(m.vel);
  in.read(m.state);
}

void write(Writer& out, const CmdVel& m) {
  out.write(m.vel);
  out.write(m.state);
}

void to_json(std::string& out, const CmdVel& m) {
  json_key(out, '{', "vel");
  json_value(out, m.vel);
  json_key(out, ',', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, CmdPos& m) {
  in.read(m.pos);
  in.read(m.vel);
  in.read(m.state);
}

void write(Writer& out, const CmdPos& m) {
  out.write(m.pos);
  out.write(m.vel);
  out.write(m.state);
}

void to_json(std::string& out, const CmdPos& m) {
  json_key(out, '{', "pos");
  json_value(out, m.pos);
  json_key(out, ',', "vel");
  json_value(out, m.vel);
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

void read(Reader& in, ResetOdomConfig& m) {
  in.read(m.value);
}

void write(Writer& out, const ResetOdomConfig& m) {
  out.write(m.value);
}

void to_json(std::string& out, const ResetOdomConfig& m) {
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
  in.read(m.pos);
}

void write(Writer& out, const SetOdomReq& m) {
  out.write(m.pos);
}

void to_json(std::string& out, const SetOdomReq& m) {
  json_key(out, '{', "pos");
  json_value(out, m.pos);
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
    {52, MessageType::kData, kDataState, "position1d.data.state", "position1d::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {52, MessageType::kData, kDataGeom, "position1d.data.geom", "position1d::Geom", true, Policy::kLatest,
     check_required<Geom>, reencode<Geom>, body_to_json<Geom>},
    {52, MessageType::kCmd, kCmdVel, "position1d.cmd.vel", "position1d::CmdVel", true, Policy::kLatest,
     check_required<CmdVel>, reencode<CmdVel>, body_to_json<CmdVel>},
    {52, MessageType::kCmd, kCmdPos, "position1d.cmd.pos", "position1d::CmdPos", true, Policy::kLatest,
     check_required<CmdPos>, reencode<CmdPos>, body_to_json<CmdPos>},
    {52, MessageType::kReq, kReqGetGeom, "position1d.req.get_geom", "position1d::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
    {52, MessageType::kReq, kReqMotorPower, "position1d.req.motor_power", "position1d::PowerConfig", true, Policy::kNone,
     check_optional<PowerConfig>, reencode<PowerConfig>, body_to_json<PowerConfig>},
    {52, MessageType::kReq, kReqVelocityMode, "position1d.req.velocity_mode", "position1d::VelocityModeConfig", true, Policy::kNone,
     check_optional<VelocityModeConfig>, reencode<VelocityModeConfig>, body_to_json<VelocityModeConfig>},
    {52, MessageType::kReq, kReqPositionMode, "position1d.req.position_mode", "position1d::PositionModeReq", true, Policy::kNone,
     check_optional<PositionModeReq>, reencode<PositionModeReq>, body_to_json<PositionModeReq>},
    {52, MessageType::kReq, kReqSetOdom, "position1d.req.set_odom", "position1d::SetOdomReq", true, Policy::kNone,
     check_optional<SetOdomReq>, reencode<SetOdomReq>, body_to_json<SetOdomReq>},
    {52, MessageType::kReq, kReqResetOdom, "position1d.req.reset_odom", "position1d::ResetOdomConfig", true, Policy::kNone,
     check_optional<ResetOdomConfig>, reencode<ResetOdomConfig>, body_to_json<ResetOdomConfig>},
    {52, MessageType::kReq, kReqSpeedPid, "position1d.req.speed_pid", "position1d::SpeedPidReq", true, Policy::kNone,
     check_optional<SpeedPidReq>, reencode<SpeedPidReq>, body_to_json<SpeedPidReq>},
    {52, MessageType::kReq, kReqPositionPid, "position1d.req.position_pid", "position1d::PositionPidReq", true, Policy::kNone,
     check_optional<PositionPidReq>, reencode<PositionPidReq>, body_to_json<PositionPidReq>},
    {52, MessageType::kReq, kReqSpeedProf, "position1d.req.speed_prof", "position1d::SpeedProfReq", true, Policy::kNone,
     check_optional<SpeedProfReq>, reencode<SpeedProfReq>, body_to_json<SpeedProfReq>},
};

}  // namespace playhouse::wire::position1d
