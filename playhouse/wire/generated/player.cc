// Generated from interfaces/001_player.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/player.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::player {

void read(Reader& in, DeviceDevlist& m) {
  std::uint32_t devices_count = 0;
  in.read(devices_count);
  m.devices.resize(in.counted_length("devices", 4096, 16));
  for (auto& element : m.devices) read(in, element);
}

void write(Writer& out, const DeviceDevlist& m) {
  out.write_length("devices", m.devices.size(), 4096);
  out.write_length("devices", m.devices.size(), 4096);
  for (const auto& element : m.devices) write(out, element);
}

void to_json(std::string& out, const DeviceDevlist& m) {
  json_key(out, '{', "devices");
  json_array(out, m.devices, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, DeviceDriverinfo& m) {
  read(in, m.addr);
  std::uint32_t driver_name_count = 0;
  in.read(driver_name_count);
  in.read_bytes(m.driver_name, in.counted_length("driver_name", 64, 1));
}

void write(Writer& out, const DeviceDriverinfo& m) {
  write(out, m.addr);
  out.write_length("driver_name", m.driver_name.size(), 64);
  out.write_length("driver_name", m.driver_name.size(), 64);
  out.write_bytes(std::as_bytes(std::span(m.driver_name)));
}

void to_json(std::string& out, const DeviceDriverinfo& m) {
  json_key(out, '{', "addr");
  to_json(out, m.addr);
  json_key(out, ',', "driver_name");
  json_text(out, m.driver_name);
  out += '}';
}

void read(Reader& in, DeviceReq& m) {
  read(in, m.addr);
  in.read(m.access);
  std::uint32_t driver_name_count = 0;
  in.read(driver_name_count);
  in.read_bytes(m.driver_name, in.counted_length("driver_name", 64, 1));
}

void write(Writer& out, const DeviceReq& m) {
  write(out, m.addr);
  out.write(m.access);
  out.write_length("driver_name", m.driver_name.size(), 64);
  out.write_length("driver_name", m.driver_name.size(), 64);
  out.write_bytes(std::as_bytes(std::span(m.driver_name)));
}

void to_json(std::string& out, const DeviceReq& m) {
  json_key(out, '{', "addr");
  to_json(out, m.addr);
  json_key(out, ',', "access");
  json_value(out, m.access);
  json_key(out, ',', "driver_name");
  json_text(out, m.driver_name);
  out += '}';
}

void read(Reader& in, DeviceDatamodeReq& m) {
  in.read(m.mode);
}

void write(Writer& out, const DeviceDatamodeReq& m) {
  out.write(m.mode);
}

void to_json(std::string& out, const DeviceDatamodeReq& m) {
  json_key(out, '{', "mode");
  json_value(out, m.mode);
  out += '}';
}

void read(Reader& in, DeviceAuthReq& m) {
  std::uint32_t auth_key_count = 0;
  in.read(auth_key_count);
  in.read_bytes(m.auth_key, in.counted_length("auth_key", 32, 1));
}

void write(Writer& out, const DeviceAuthReq& m) {
  out.write_length("auth_key", m.auth_key.size(), 32);
  out.write_length("auth_key", m.auth_key.size(), 32);
  out.write_bytes(std::as_bytes(std::span(m.auth_key)));
}

void to_json(std::string& out, const DeviceAuthReq& m) {
  json_key(out, '{', "auth_key");
  json_bytes(out, m.auth_key);
  out += '}';
}

void read(Reader& in, DeviceNameserviceReq& m) {
  std::uint32_t name_count = 0;
  in.read(name_count);
  in.read_bytes(m.name, in.counted_length("name", 64, 1));
  in.read(m.port);
}

void write(Writer& out, const DeviceNameserviceReq& m) {
  out.write_length("name", m.name.size(), 64);
  out.write_length("name", m.name.size(), 64);
  out.write_bytes(std::as_bytes(std::span(m.name)));
  out.write(m.port);
}

void to_json(std::string& out, const DeviceNameserviceReq& m) {
  json_key(out, '{', "name");
  json_bytes(out, m.name);
  json_key(out, ',', "port");
  json_value(out, m.port);
  out += '}';
}

void read(Reader& in, AddReplaceRuleReq& m) {
  in.read(m.interf);
  in.read(m.index);
  in.read(m.type);
  in.read(m.subtype);
  in.read(m.replace);
}

void write(Writer& out, const AddReplaceRuleReq& m) {
  out.write(m.interf);
  out.write(m.index);
  out.write(m.type);
  out.write(m.subtype);
  out.write(m.replace);
}

void to_json(std::string& out, const AddReplaceRuleReq& m) {
  json_key(out, '{', "interf");
  json_value(out, m.interf);
  json_key(out, ',', "index");
  json_value(out, m.index);
  json_key(out, ',', "type");
  json_value(out, m.type);
  json_key(out, ',', "subtype");
  json_value(out, m.subtype);
  json_key(out, ',', "replace");
  json_value(out, m.replace);
  out += '}';
}

const MessageDef kRows[10] = {
    {1, MessageType::kReq, kReqDevlist, "player.req.devlist", "player::DeviceDevlist", true, Policy::kNone,
     check_optional<DeviceDevlist>, reencode<DeviceDevlist>, body_to_json<DeviceDevlist>},
    {1, MessageType::kReq, kReqDriverinfo, "player.req.driverinfo", "player::DeviceDriverinfo", true, Policy::kNone,
     check_optional<DeviceDriverinfo>, reencode<DeviceDriverinfo>, body_to_json<DeviceDriverinfo>},
    {1, MessageType::kReq, kReqDev, "player.req.dev", "player::DeviceReq", true, Policy::kNone,
     check_optional<DeviceReq>, reencode<DeviceReq>, body_to_json<DeviceReq>},
    {1, MessageType::kReq, kReqData, "player.req.data", "", false, Policy::kNone,
     check_nothing, reencode_nothing, nothing_to_json},
    {1, MessageType::kReq, kReqDatamode, "player.req.datamode", "player::DeviceDatamodeReq", true, Policy::kNone,
     check_optional<DeviceDatamodeReq>, reencode<DeviceDatamodeReq>, body_to_json<DeviceDatamodeReq>},
    {1, MessageType::kReq, kReqAuth, "player.req.auth", "player::DeviceAuthReq", true, Policy::kNone,
     check_optional<DeviceAuthReq>, reencode<DeviceAuthReq>, body_to_json<DeviceAuthReq>},
    {1, MessageType::kReq, kReqNameservice, "player.req.nameservice", "player::DeviceNameserviceReq", true, Policy::kNone,
     check_optional<DeviceNameserviceReq>, reencode<DeviceNameserviceReq>, body_to_json<DeviceNameserviceReq>},
    {1, MessageType::kReq, kReqAddReplaceRule, "player.req.add_replace_rule", "player::AddReplaceRuleReq", true, Policy::kNone,
     check_optional<AddReplaceRuleReq>, reencode<AddReplaceRuleReq>, body_to_json<AddReplaceRuleReq>},
    {1, MessageType::kSynch, kSynchOk, "player.synch.ok", "", false, Policy::kNone,
     check_nothing, reencode_nothing, nothing_to_json},
    {1, MessageType::kSynch, kSynchOverflow, "player.synch.overflow", "Uint32", true, Policy::kNone,
     check_optional<Uint32>, reencode<Uint32>, body_to_json<Uint32>},
};

}  // namespace playhouse::wire::player
