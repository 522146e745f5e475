// Generated from interfaces/031_simulation.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/simulation.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::simulation {

void read(Reader& in, Data& m) {
  in.read(m.data);
}

void write(Writer& out, const Data& m) {
  out.write(m.data);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "data");
  json_value(out, m.data);
  out += '}';
}

void read(Reader& in, Cmd& m) {
  in.read(m.cmd);
}

void write(Writer& out, const Cmd& m) {
  out.write(m.cmd);
}

void to_json(std::string& out, const Cmd& m) {
  json_key(out, '{', "cmd");
  json_value(out, m.cmd);
  out += '}';
}

void read(Reader& in, Pose2dReq& m) {
  std::uint32_t name_count = 0;
  in.read(name_count);
  in.read_bytes(m.name, in.dynamic_length("name", name_count, 1));
  read(in, m.pose);
}

void write(Writer& out, const Pose2dReq& m) {
  out.write_length("name", m.name.size(), 33554392);
  out.write_length("name", m.name.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.name)));
  write(out, m.pose);
}

void to_json(std::string& out, const Pose2dReq& m) {
  json_key(out, '{', "name");
  json_text(out, m.name);
  json_key(out, ',', "pose");
  to_json(out, m.pose);
  out += '}';
}

void read(Reader& in, Pose3dReq& m) {
  std::uint32_t name_count = 0;
  in.read(name_count);
  in.read_bytes(m.name, in.dynamic_length("name", name_count, 1));
  read(in, m.pose);
  in.read(m.simtime);
}

void write(Writer& out, const Pose3dReq& m) {
  out.write_length("name", m.name.size(), 33554392);
  out.write_length("name", m.name.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.name)));
  write(out, m.pose);
  out.write(m.simtime);
}

void to_json(std::string& out, const Pose3dReq& m) {
  json_key(out, '{', "name");
  json_text(out, m.name);
  json_key(out, ',', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "simtime");
  json_value(out, m.simtime);
  out += '}';
}

void read(Reader& in, PropertyReq& m) {
  std::uint32_t name_count = 0;
  in.read(name_count);
  in.read_bytes(m.name, in.dynamic_length("name", name_count, 1));
  std::uint32_t prop_count = 0;
  in.read(prop_count);
  in.read_bytes(m.prop, in.dynamic_length("prop", prop_count, 1));
  in.read(m.index);
  std::uint32_t value_count = 0;
  in.read(value_count);
  in.read_bytes(m.value, in.dynamic_length("value", value_count, 1));
}

void write(Writer& out, const PropertyReq& m) {
  out.write_length("name", m.name.size(), 33554392);
  out.write_length("name", m.name.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.name)));
  out.write_length("prop", m.prop.size(), 33554392);
  out.write_length("prop", m.prop.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.prop)));
  out.write(m.index);
  out.write_length("value", m.value.size(), 33554392);
  out.write_length("value", m.value.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.value)));
}

void to_json(std::string& out, const PropertyReq& m) {
  json_key(out, '{', "name");
  json_text(out, m.name);
  json_key(out, ',', "prop");
  json_text(out, m.prop);
  json_key(out, ',', "index");
  json_value(out, m.index);
  json_key(out, ',', "value");
  json_text(out, m.value);
  out += '}';
}

const MessageDef kRows[9] = {
    {31, MessageType::kCmd, kCmdPause, "simulation.cmd.pause", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {31, MessageType::kCmd, kCmdReset, "simulation.cmd.reset", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {31, MessageType::kCmd, kCmdSave, "simulation.cmd.save", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {31, MessageType::kReq, kReqGetPose2d, "simulation.req.get_pose2d", "simulation::Pose2dReq", true, Policy::kNone,
     check_optional<Pose2dReq>, reencode<Pose2dReq>, body_to_json<Pose2dReq>},
    {31, MessageType::kReq, kReqSetPose2d, "simulation.req.set_pose2d", "simulation::Pose2dReq", true, Policy::kNone,
     check_optional<Pose2dReq>, reencode<Pose2dReq>, body_to_json<Pose2dReq>},
    {31, MessageType::kReq, kReqGetPose3d, "simulation.req.get_pose3d", "simulation::Pose3dReq", true, Policy::kNone,
     check_optional<Pose3dReq>, reencode<Pose3dReq>, body_to_json<Pose3dReq>},
    {31, MessageType::kReq, kReqSetPose3d, "simulation.req.set_pose3d", "simulation::Pose3dReq", true, Policy::kNone,
     check_optional<Pose3dReq>, reencode<Pose3dReq>, body_to_json<Pose3dReq>},
    {31, MessageType::kReq, kReqGetProperty, "simulation.req.get_property", "simulation::PropertyReq", true, Policy::kNone,
     check_optional<PropertyReq>, reencode<PropertyReq>, body_to_json<PropertyReq>},
    {31, MessageType::kReq, kReqSetProperty, "simulation.req.set_property", "simulation::PropertyReq", true, Policy::kNone,
     check_optional<PropertyReq>, reencode<PropertyReq>, body_to_json<PropertyReq>},
};

}  // namespace playhouse::wire::simulation
