// Generated from interfaces/057_wsn.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/wsn.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::wsn {

void read(Reader& in, NodeData& m) {
  in.read(m.light);
  in.read(m.mic);
  in.read(m.accel_x);
  in.read(m.accel_y);
  in.read(m.accel_z);
  in.read(m.magn_x);
  in.read(m.magn_y);
  in.read(m.magn_z);
  in.read(m.temperature);
  in.read(m.battery);
}

void write(Writer& out, const NodeData& m) {
  out.write(m.light);
  out.write(m.mic);
  out.write(m.accel_x);
  out.write(m.accel_y);
  out.write(m.accel_z);
  out.write(m.magn_x);
  out.write(m.magn_y);
  out.write(m.magn_z);
  out.write(m.temperature);
  out.write(m.battery);
}

void to_json(std::string& out, const NodeData& m) {
  json_key(out, '{', "light");
  json_value(out, m.light);
  json_key(out, ',', "mic");
  json_value(out, m.mic);
  json_key(out, ',', "accel_x");
  json_value(out, m.accel_x);
  json_key(out, ',', "accel_y");
  json_value(out, m.accel_y);
  json_key(out, ',', "accel_z");
  json_value(out, m.accel_z);
  json_key(out, ',', "magn_x");
  json_value(out, m.magn_x);
  json_key(out, ',', "magn_y");
  json_value(out, m.magn_y);
  json_key(out, ',', "magn_z");
  json_value(out, m.magn_z);
  json_key(out, ',', "temperature");
  json_value(out, m.temperature);
  json_key(out, ',', "battery");
  json_value(out, m.battery);
  out += '}';
}

void read(Reader& in, Data& m) {
  in.read(m.node_type);
  in.read(m.node_id);
  in.read(m.node_parent_id);
  read(in, m.data_packet);
}

void write(Writer& out, const Data& m) {
  out.write(m.node_type);
  out.write(m.node_id);
  out.write(m.node_parent_id);
  write(out, m.data_packet);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "node_type");
  json_value(out, m.node_type);
  json_key(out, ',', "node_id");
  json_value(out, m.node_id);
  json_key(out, ',', "node_parent_id");
  json_value(out, m.node_parent_id);
  json_key(out, ',', "data_packet");
  to_json(out, m.data_packet);
  out += '}';
}

void read(Reader& in, Cmd& m) {
  in.read(m.node_id);
  in.read(m.group_id);
  in.read(m.device);
  in.read(m.enable);
}

void write(Writer& out, const Cmd& m) {
  out.write(m.node_id);
  out.write(m.group_id);
  out.write(m.device);
  out.write(m.enable);
}

void to_json(std::string& out, const Cmd& m) {
  json_key(out, '{', "node_id");
  json_value(out, m.node_id);
  json_key(out, ',', "group_id");
  json_value(out, m.group_id);
  json_key(out, ',', "device");
  json_value(out, m.device);
  json_key(out, ',', "enable");
  json_value(out, m.enable);
  out += '}';
}

void read(Reader& in, PowerConfig& m) {
  in.read(m.node_id);
  in.read(m.group_id);
  in.read(m.value);
}

void write(Writer& out, const PowerConfig& m) {
  out.write(m.node_id);
  out.write(m.group_id);
  out.write(m.value);
}

void to_json(std::string& out, const PowerConfig& m) {
  json_key(out, '{', "node_id");
  json_value(out, m.node_id);
  json_key(out, ',', "group_id");
  json_value(out, m.group_id);
  json_key(out, ',', "value");
  json_value(out, m.value);
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

void read(Reader& in, DatafreqConfig& m) {
  in.read(m.node_id);
  in.read(m.group_id);
  in.read(m.frequency);
}

void write(Writer& out, const DatafreqConfig& m) {
  out.write(m.node_id);
  out.write(m.group_id);
  out.write(m.frequency);
}

void to_json(std::string& out, const DatafreqConfig& m) {
  json_key(out, '{', "node_id");
  json_value(out, m.node_id);
  json_key(out, ',', "group_id");
  json_value(out, m.group_id);
  json_key(out, ',', "frequency");
  json_value(out, m.frequency);
  out += '}';
}

const MessageDef kRows[5] = {
    {57, MessageType::kData, kDataState, "wsn.data.state", "wsn::Data", true, Policy::kQueue,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {57, MessageType::kCmd, kCmdDevstate, "wsn.cmd.devstate", "wsn::Cmd", true, Policy::kQueue,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
    {57, MessageType::kReq, kReqPower, "wsn.req.power", "wsn::PowerConfig", true, Policy::kNone,
     check_optional<PowerConfig>, reencode<PowerConfig>, body_to_json<PowerConfig>},
    {57, MessageType::kReq, kReqDatatype, "wsn.req.datatype", "wsn::DatatypeConfig", true, Policy::kNone,
     check_optional<DatatypeConfig>, reencode<DatatypeConfig>, body_to_json<DatatypeConfig>},
    {57, MessageType::kReq, kReqDatafreq, "wsn.req.datafreq", "wsn::DatafreqConfig", true, Policy::kNone,
     check_optional<DatafreqConfig>, reencode<DatafreqConfig>, body_to_json<DatafreqConfig>},
};

}  // namespace playhouse::wire::wsn
