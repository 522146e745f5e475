// Generated from interfaces/066_coopobject.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/coopobject.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::coopobject {

void read(Reader& in, Header& m) {
  in.read(m.origin);
  in.read(m.id);
  in.read(m.parent_id);
}

void write(Writer& out, const Header& m) {
  out.write(m.origin);
  out.write(m.id);
  out.write(m.parent_id);
}

void to_json(std::string& out, const Header& m) {
  json_key(out, '{', "origin");
  json_value(out, m.origin);
  json_key(out, ',', "id");
  json_value(out, m.id);
  json_key(out, ',', "parent_id");
  json_value(out, m.parent_id);
  out += '}';
}

void read(Reader& in, Rssi& m) {
  read(in, m.header);
  in.read(m.sender_id);
  in.read(m.rssi);
  in.read(m.stamp);
  in.read(m.nodeTimeHigh);
  in.read(m.nodeTimeLow);
  in.read(m.x);
  in.read(m.y);
  in.read(m.z);
}

void write(Writer& out, const Rssi& m) {
  write(out, m.header);
  out.write(m.sender_id);
  out.write(m.rssi);
  out.write(m.stamp);
  out.write(m.nodeTimeHigh);
  out.write(m.nodeTimeLow);
  out.write(m.x);
  out.write(m.y);
  out.write(m.z);
}

void to_json(std::string& out, const Rssi& m) {
  json_key(out, '{', "header");
  to_json(out, m.header);
  json_key(out, ',', "sender_id");
  json_value(out, m.sender_id);
  json_key(out, ',', "rssi");
  json_value(out, m.rssi);
  json_key(out, ',', "stamp");
  json_value(out, m.stamp);
  json_key(out, ',', "nodeTimeHigh");
  json_value(out, m.nodeTimeHigh);
  json_key(out, ',', "nodeTimeLow");
  json_value(out, m.nodeTimeLow);
  json_key(out, ',', "x");
  json_value(out, m.x);
  json_key(out, ',', "y");
  json_value(out, m.y);
  json_key(out, ',', "z");
  json_value(out, m.z);
  out += '}';
}

void read(Reader& in, Position& m) {
  read(in, m.header);
  in.read(m.x);
  in.read(m.y);
  in.read(m.z);
  in.read(m.status);
}

void write(Writer& out, const Position& m) {
  write(out, m.header);
  out.write(m.x);
  out.write(m.y);
  out.write(m.z);
  out.write(m.status);
}

void to_json(std::string& out, const Position& m) {
  json_key(out, '{', "header");
  to_json(out, m.header);
  json_key(out, ',', "x");
  json_value(out, m.x);
  json_key(out, ',', "y");
  json_value(out, m.y);
  json_key(out, ',', "z");
  json_value(out, m.z);
  json_key(out, ',', "status");
  json_value(out, m.status);
  out += '}';
}

void read(Reader& in, Sensor& m) {
  in.read(m.type);
  in.read(m.value);
}

void write(Writer& out, const Sensor& m) {
  out.write(m.type);
  out.write(m.value);
}

void to_json(std::string& out, const Sensor& m) {
  json_key(out, '{', "type");
  json_value(out, m.type);
  json_key(out, ',', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, DataSensor& m) {
  read(in, m.header);
  std::uint32_t data_count = 0;
  in.read(data_count);
  m.data.resize(in.dynamic_length("data", data_count, 8));
  for (auto& element : m.data) read(in, element);
}

void write(Writer& out, const DataSensor& m) {
  write(out, m.header);
  out.write_length("data", m.data.size(), 4194299);
  out.write_length("data", m.data.size(), 4194299);
  for (const auto& element : m.data) write(out, element);
}

void to_json(std::string& out, const DataSensor& m) {
  json_key(out, '{', "header");
  to_json(out, m.header);
  json_key(out, ',', "data");
  json_array(out, m.data, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, DataUserdefined& m) {
  read(in, m.header);
  in.read(m.type);
  std::uint32_t data_count = 0;
  in.read(data_count);
  in.read_bytes(m.data, in.dynamic_length("data", data_count, 1));
}

void write(Writer& out, const DataUserdefined& m) {
  write(out, m.header);
  out.write(m.type);
  out.write_length("data", m.data.size(), 33554392);
  out.write_length("data", m.data.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.data)));
}

void to_json(std::string& out, const DataUserdefined& m) {
  json_key(out, '{', "header");
  to_json(out, m.header);
  json_key(out, ',', "type");
  json_value(out, m.type);
  json_key(out, ',', "data");
  json_bytes(out, m.data);
  out += '}';
}

void read(Reader& in, Req& m) {
  read(in, m.header);
  in.read(m.request);
  std::uint32_t parameters_count = 0;
  in.read(parameters_count);
  in.read_bytes(m.parameters, in.dynamic_length("parameters", parameters_count, 1));
}

void write(Writer& out, const Req& m) {
  write(out, m.header);
  out.write(m.request);
  out.write_length("parameters", m.parameters.size(), 33554392);
  out.write_length("parameters", m.parameters.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.parameters)));
}

void to_json(std::string& out, const Req& m) {
  json_key(out, '{', "header");
  to_json(out, m.header);
  json_key(out, ',', "request");
  json_value(out, m.request);
  json_key(out, ',', "parameters");
  json_bytes(out, m.parameters);
  out += '}';
}

void read(Reader& in, Cmd& m) {
  read(in, m.header);
  in.read(m.command);
  std::uint32_t parameters_count = 0;
  in.read(parameters_count);
  in.read_bytes(m.parameters, in.dynamic_length("parameters", parameters_count, 1));
}

void write(Writer& out, const Cmd& m) {
  write(out, m.header);
  out.write(m.command);
  out.write_length("parameters", m.parameters.size(), 33554392);
  out.write_length("parameters", m.parameters.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.parameters)));
}

void to_json(std::string& out, const Cmd& m) {
  json_key(out, '{', "header");
  to_json(out, m.header);
  json_key(out, ',', "command");
  json_value(out, m.command);
  json_key(out, ',', "parameters");
  json_bytes(out, m.parameters);
  out += '}';
}

const MessageDef kRows[12] = {
    {66, MessageType::kData, kDataHealth, "coopobject.data.health", "coopobject::Header", true, Policy::kQueue,
     check_required<Header>, reencode<Header>, body_to_json<Header>},
    {66, MessageType::kData, kDataRssi, "coopobject.data.rssi", "coopobject::Rssi", true, Policy::kQueue,
     check_required<Rssi>, reencode<Rssi>, body_to_json<Rssi>},
    {66, MessageType::kData, kDataSensor, "coopobject.data.sensor", "coopobject::DataSensor", true, Policy::kQueue,
     check_required<DataSensor>, reencode<DataSensor>, body_to_json<DataSensor>},
    {66, MessageType::kData, kDataAlarm, "coopobject.data.alarm", "coopobject::DataSensor", true, Policy::kQueue,
     check_required<DataSensor>, reencode<DataSensor>, body_to_json<DataSensor>},
    {66, MessageType::kData, kDataUserdefined, "coopobject.data.userdefined", "coopobject::DataUserdefined", true, Policy::kQueue,
     check_required<DataUserdefined>, reencode<DataUserdefined>, body_to_json<DataUserdefined>},
    {66, MessageType::kData, kDataRequest, "coopobject.data.request", "coopobject::Req", true, Policy::kQueue,
     check_required<Req>, reencode<Req>, body_to_json<Req>},
    {66, MessageType::kData, kDataCommand, "coopobject.data.command", "coopobject::Cmd", true, Policy::kQueue,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
    {66, MessageType::kData, kDataPosition, "coopobject.data.position", "coopobject::Position", true, Policy::kQueue,
     check_required<Position>, reencode<Position>, body_to_json<Position>},
    {66, MessageType::kCmd, kCmdStandard, "coopobject.cmd.standard", "coopobject::Cmd", true, Policy::kQueue,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
    {66, MessageType::kCmd, kCmdData, "coopobject.cmd.data", "coopobject::DataUserdefined", true, Policy::kQueue,
     check_required<DataUserdefined>, reencode<DataUserdefined>, body_to_json<DataUserdefined>},
    {66, MessageType::kCmd, kCmdPosition, "coopobject.cmd.position", "coopobject::Position", true, Policy::kQueue,
     check_required<Position>, reencode<Position>, body_to_json<Position>},
    {66, MessageType::kReq, kReqStandard, "coopobject.req.standard", "coopobject::Req", true, Policy::kNone,
     check_optional<Req>, reencode<Req>, body_to_json<Req>},
};

}  // namespace playhouse::wire::coopobject
