// Generated from interfaces/054_limb.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/limb.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::limb {

void read(Reader& in, Data& m) {
  read(in, m.position);
  read(in, m.approach);
  read(in, m.orientation);
  in.read(m.state);
}

void write(Writer& out, const Data& m) {
  write(out, m.position);
  write(out, m.approach);
  write(out, m.orientation);
  out.write(m.state);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "position");
  to_json(out, m.position);
  json_key(out, ',', "approach");
  to_json(out, m.approach);
  json_key(out, ',', "orientation");
  to_json(out, m.orientation);
  json_key(out, ',', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, SetposeCmd& m) {
  read(in, m.position);
  read(in, m.approach);
  read(in, m.orientation);
}

void write(Writer& out, const SetposeCmd& m) {
  write(out, m.position);
  write(out, m.approach);
  write(out, m.orientation);
}

void to_json(std::string& out, const SetposeCmd& m) {
  json_key(out, '{', "position");
  to_json(out, m.position);
  json_key(out, ',', "approach");
  to_json(out, m.approach);
  json_key(out, ',', "orientation");
  to_json(out, m.orientation);
  out += '}';
}

void read(Reader& in, SetpositionCmd& m) {
  read(in, m.position);
}

void write(Writer& out, const SetpositionCmd& m) {
  write(out, m.position);
}

void to_json(std::string& out, const SetpositionCmd& m) {
  json_key(out, '{', "position");
  to_json(out, m.position);
  out += '}';
}

void read(Reader& in, VecmoveCmd& m) {
  read(in, m.direction);
  in.read(m.length);
}

void write(Writer& out, const VecmoveCmd& m) {
  write(out, m.direction);
  out.write(m.length);
}

void to_json(std::string& out, const VecmoveCmd& m) {
  json_key(out, '{', "direction");
  to_json(out, m.direction);
  json_key(out, ',', "length");
  json_value(out, m.length);
  out += '}';
}

void read(Reader& in, PowerReq& m) {
  in.read(m.value);
}

void write(Writer& out, const PowerReq& m) {
  out.write(m.value);
}

void to_json(std::string& out, const PowerReq& m) {
  json_key(out, '{', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, BrakesReq& m) {
  in.read(m.value);
}

void write(Writer& out, const BrakesReq& m) {
  out.write(m.value);
}

void to_json(std::string& out, const BrakesReq& m) {
  json_key(out, '{', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, GeomReq& m) {
  read(in, m.basePos);
}

void write(Writer& out, const GeomReq& m) {
  write(out, m.basePos);
}

void to_json(std::string& out, const GeomReq& m) {
  json_key(out, '{', "basePos");
  to_json(out, m.basePos);
  out += '}';
}

void read(Reader& in, SpeedReq& m) {
  in.read(m.speed);
}

void write(Writer& out, const SpeedReq& m) {
  out.write(m.speed);
}

void to_json(std::string& out, const SpeedReq& m) {
  json_key(out, '{', "speed");
  json_value(out, m.speed);
  out += '}';
}

const MessageDef kRows[10] = {
    {54, MessageType::kData, kDataState, "limb.data.state", "limb::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {54, MessageType::kCmd, kCmdHome, "limb.cmd.home", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {54, MessageType::kCmd, kCmdStop, "limb.cmd.stop", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {54, MessageType::kCmd, kCmdSetpose, "limb.cmd.setpose", "limb::SetposeCmd", true, Policy::kLatest,
     check_required<SetposeCmd>, reencode<SetposeCmd>, body_to_json<SetposeCmd>},
    {54, MessageType::kCmd, kCmdSetposition, "limb.cmd.setposition", "limb::SetpositionCmd", true, Policy::kLatest,
     check_required<SetpositionCmd>, reencode<SetpositionCmd>, body_to_json<SetpositionCmd>},
    {54, MessageType::kCmd, kCmdVecmove, "limb.cmd.vecmove", "limb::VecmoveCmd", true, Policy::kQueue,
     check_required<VecmoveCmd>, reencode<VecmoveCmd>, body_to_json<VecmoveCmd>},
    {54, MessageType::kReq, kReqPower, "limb.req.power", "limb::PowerReq", true, Policy::kNone,
     check_optional<PowerReq>, reencode<PowerReq>, body_to_json<PowerReq>},
    {54, MessageType::kReq, kReqBrakes, "limb.req.brakes", "limb::BrakesReq", true, Policy::kNone,
     check_optional<BrakesReq>, reencode<BrakesReq>, body_to_json<BrakesReq>},
    {54, MessageType::kReq, kReqGeom, "limb.req.geom", "limb::GeomReq", true, Policy::kNone,
     check_optional<GeomReq>, reencode<GeomReq>, body_to_json<GeomReq>},
    {54, MessageType::kReq, kReqSpeed, "limb.req.speed", "limb::SpeedReq", true, Policy::kNone,
     check_optional<SpeedReq>, reencode<SpeedReq>, body_to_json<SpeedReq>},
};

}  // namespace playhouse::wire::limb
