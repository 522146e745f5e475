// Generated from interfaces/003_gripper.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/gripper.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::gripper {

void read(Reader& in, Data& m) {
  in.read(m.state);
  in.read(m.beams);
  in.read(m.stored);
}

void write(Writer& out, const Data& m) {
  out.write(m.state);
  out.write(m.beams);
  out.write(m.stored);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  json_key(out, ',', "beams");
  json_value(out, m.beams);
  json_key(out, ',', "stored");
  json_value(out, m.stored);
  out += '}';
}

void read(Reader& in, Geom& m) {
  read(in, m.pose);
  read(in, m.outer_size);
  read(in, m.inner_size);
  in.read(m.num_beams);
  in.read(m.capacity);
}

void write(Writer& out, const Geom& m) {
  write(out, m.pose);
  write(out, m.outer_size);
  write(out, m.inner_size);
  out.write(m.num_beams);
  out.write(m.capacity);
}

void to_json(std::string& out, const Geom& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "outer_size");
  to_json(out, m.outer_size);
  json_key(out, ',', "inner_size");
  to_json(out, m.inner_size);
  json_key(out, ',', "num_beams");
  json_value(out, m.num_beams);
  json_key(out, ',', "capacity");
  json_value(out, m.capacity);
  out += '}';
}

const MessageDef kRows[7] = {
    {3, MessageType::kData, kDataState, "gripper.data.state", "gripper::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {3, MessageType::kCmd, kCmdOpen, "gripper.cmd.open", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {3, MessageType::kCmd, kCmdClose, "gripper.cmd.close", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {3, MessageType::kCmd, kCmdStop, "gripper.cmd.stop", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {3, MessageType::kCmd, kCmdStore, "gripper.cmd.store", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {3, MessageType::kCmd, kCmdRetrieve, "gripper.cmd.retrieve", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {3, MessageType::kReq, kReqGetGeom, "gripper.req.get_geom", "gripper::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
};

}  // namespace playhouse::wire::gripper
