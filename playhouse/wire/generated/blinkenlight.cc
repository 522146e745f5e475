// Generated from interfaces/033_blinkenlight.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/blinkenlight.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::blinkenlight {

void read(Reader& in, Data& m) {
  in.read(m.enable);
  in.read(m.period);
  in.read(m.dutycycle);
  read(in, m.color);
}

void write(Writer& out, const Data& m) {
  out.write(m.enable);
  out.write(m.period);
  out.write(m.dutycycle);
  write(out, m.color);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "enable");
  json_value(out, m.enable);
  json_key(out, ',', "period");
  json_value(out, m.period);
  json_key(out, ',', "dutycycle");
  json_value(out, m.dutycycle);
  json_key(out, ',', "color");
  to_json(out, m.color);
  out += '}';
}

void read(Reader& in, Cmd& m) {
  in.read(m.id);
  in.read(m.enable);
  in.read(m.period);
  in.read(m.dutycycle);
  read(in, m.color);
}

void write(Writer& out, const Cmd& m) {
  out.write(m.id);
  out.write(m.enable);
  out.write(m.period);
  out.write(m.dutycycle);
  write(out, m.color);
}

void to_json(std::string& out, const Cmd& m) {
  json_key(out, '{', "id");
  json_value(out, m.id);
  json_key(out, ',', "enable");
  json_value(out, m.enable);
  json_key(out, ',', "period");
  json_value(out, m.period);
  json_key(out, ',', "dutycycle");
  json_value(out, m.dutycycle);
  json_key(out, ',', "color");
  to_json(out, m.color);
  out += '}';
}

void read(Reader& in, CmdPower& m) {
  in.read(m.id);
  in.read(m.enable);
}

void write(Writer& out, const CmdPower& m) {
  out.write(m.id);
  out.write(m.enable);
}

void to_json(std::string& out, const CmdPower& m) {
  json_key(out, '{', "id");
  json_value(out, m.id);
  json_key(out, ',', "enable");
  json_value(out, m.enable);
  out += '}';
}

void read(Reader& in, CmdColor& m) {
  in.read(m.id);
  read(in, m.color);
}

void write(Writer& out, const CmdColor& m) {
  out.write(m.id);
  write(out, m.color);
}

void to_json(std::string& out, const CmdColor& m) {
  json_key(out, '{', "id");
  json_value(out, m.id);
  json_key(out, ',', "color");
  to_json(out, m.color);
  out += '}';
}

void read(Reader& in, CmdFlash& m) {
  in.read(m.id);
  in.read(m.period);
  in.read(m.dutycycle);
}

void write(Writer& out, const CmdFlash& m) {
  out.write(m.id);
  out.write(m.period);
  out.write(m.dutycycle);
}

void to_json(std::string& out, const CmdFlash& m) {
  json_key(out, '{', "id");
  json_value(out, m.id);
  json_key(out, ',', "period");
  json_value(out, m.period);
  json_key(out, ',', "dutycycle");
  json_value(out, m.dutycycle);
  out += '}';
}

const MessageDef kRows[5] = {
    {33, MessageType::kData, kDataState, "blinkenlight.data.state", "blinkenlight::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {33, MessageType::kCmd, kCmdState, "blinkenlight.cmd.state", "blinkenlight::Cmd", true, Policy::kQueue,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
    {33, MessageType::kCmd, kCmdPower, "blinkenlight.cmd.power", "blinkenlight::CmdPower", true, Policy::kQueue,
     check_required<CmdPower>, reencode<CmdPower>, body_to_json<CmdPower>},
    {33, MessageType::kCmd, kCmdColor, "blinkenlight.cmd.color", "blinkenlight::CmdColor", true, Policy::kQueue,
     check_required<CmdColor>, reencode<CmdColor>, body_to_json<CmdColor>},
    {33, MessageType::kCmd, kCmdFlash, "blinkenlight.cmd.flash", "blinkenlight::CmdFlash", true, Policy::kQueue,
     check_required<CmdFlash>, reencode<CmdFlash>, body_to_json<CmdFlash>},
};

}  // namespace playhouse::wire::blinkenlight
