// Generated from interfaces/008_ptz.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/ptz.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::ptz {

void read(Reader& in, Data& m) {
  in.read(m.pan);
  in.read(m.tilt);
  in.read(m.zoom);
  in.read(m.panspeed);
  in.read(m.tiltspeed);
  in.read(m.status);
}

void write(Writer& out, const Data& m) {
  out.write(m.pan);
  out.write(m.tilt);
  out.write(m.zoom);
  out.write(m.panspeed);
  out.write(m.tiltspeed);
  out.write(m.status);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "pan");
  json_value(out, m.pan);
  json_key(out, ',', "tilt");
  json_value(out, m.tilt);
  json_key(out, ',', "zoom");
  json_value(out, m.zoom);
  json_key(out, ',', "panspeed");
  json_value(out, m.panspeed);
  json_key(out, ',', "tiltspeed");
  json_value(out, m.tiltspeed);
  json_key(out, ',', "status");
  json_value(out, m.status);
  out += '}';
}

void read(Reader& in, Cmd& m) {
  in.read(m.pan);
  in.read(m.tilt);
  in.read(m.zoom);
  in.read(m.panspeed);
  in.read(m.tiltspeed);
}

void write(Writer& out, const Cmd& m) {
  out.write(m.pan);
  out.write(m.tilt);
  out.write(m.zoom);
  out.write(m.panspeed);
  out.write(m.tiltspeed);
}

void to_json(std::string& out, const Cmd& m) {
  json_key(out, '{', "pan");
  json_value(out, m.pan);
  json_key(out, ',', "tilt");
  json_value(out, m.tilt);
  json_key(out, ',', "zoom");
  json_value(out, m.zoom);
  json_key(out, ',', "panspeed");
  json_value(out, m.panspeed);
  json_key(out, ',', "tiltspeed");
  json_value(out, m.tiltspeed);
  out += '}';
}

void read(Reader& in, ReqStatus& m) {
  in.read(m.status);
}

void write(Writer& out, const ReqStatus& m) {
  out.write(m.status);
}

void to_json(std::string& out, const ReqStatus& m) {
  json_key(out, '{', "status");
  json_value(out, m.status);
  out += '}';
}

void read(Reader& in, Geom& m) {
  read(in, m.pos);
  read(in, m.size);
}

void write(Writer& out, const Geom& m) {
  write(out, m.pos);
  write(out, m.size);
}

void to_json(std::string& out, const Geom& m) {
  json_key(out, '{', "pos");
  to_json(out, m.pos);
  json_key(out, ',', "size");
  to_json(out, m.size);
  out += '}';
}

void read(Reader& in, ReqGeneric& m) {
  std::uint32_t config_count = 0;
  in.read(config_count);
  in.read_numbers(m.config, in.dynamic_length("config", config_count, 4));
}

void write(Writer& out, const ReqGeneric& m) {
  out.write_length("config", m.config.size(), 8388598);
  out.write_length("config", m.config.size(), 8388598);
  out.write_numbers(m.config);
}

void to_json(std::string& out, const ReqGeneric& m) {
  json_key(out, '{', "config");
  json_array(out, m.config, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, ReqControlMode& m) {
  in.read(m.mode);
}

void write(Writer& out, const ReqControlMode& m) {
  out.write(m.mode);
}

void to_json(std::string& out, const ReqControlMode& m) {
  json_key(out, '{', "mode");
  json_value(out, m.mode);
  out += '}';
}

const MessageDef kRows[7] = {
    {8, MessageType::kData, kDataState, "ptz.data.state", "ptz::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {8, MessageType::kData, kDataGeom, "ptz.data.geom", "ptz::Geom", true, Policy::kLatest,
     check_required<Geom>, reencode<Geom>, body_to_json<Geom>},
    {8, MessageType::kCmd, kCmdState, "ptz.cmd.state", "ptz::Cmd", true, Policy::kLatest,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
    {8, MessageType::kReq, kReqGeneric, "ptz.req.generic", "ptz::ReqGeneric", true, Policy::kNone,
     check_optional<ReqGeneric>, reencode<ReqGeneric>, body_to_json<ReqGeneric>},
    {8, MessageType::kReq, kReqControlMode, "ptz.req.control_mode", "ptz::ReqControlMode", true, Policy::kNone,
     check_optional<ReqControlMode>, reencode<ReqControlMode>, body_to_json<ReqControlMode>},
    {8, MessageType::kReq, kReqGeom, "ptz.req.geom", "ptz::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
    {8, MessageType::kReq, kReqStatus, "ptz.req.status", "ptz::ReqStatus", true, Policy::kNone,
     check_optional<ReqStatus>, reencode<ReqStatus>, body_to_json<ReqStatus>},
};

}  // namespace playhouse::wire::ptz
