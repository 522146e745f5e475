// Generated from interfaces/002_power.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/power.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::power {

void read(Reader& in, Data& m) {
  in.read(m.valid);
  in.read(m.volts);
  in.read(m.percent);
  in.read(m.joules);
  in.read(m.watts);
  in.read(m.charging);
}

void write(Writer& out, const Data& m) {
  out.write(m.valid);
  out.write(m.volts);
  out.write(m.percent);
  out.write(m.joules);
  out.write(m.watts);
  out.write(m.charging);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "valid");
  json_value(out, m.valid);
  json_key(out, ',', "volts");
  json_value(out, m.volts);
  json_key(out, ',', "percent");
  json_value(out, m.percent);
  json_key(out, ',', "joules");
  json_value(out, m.joules);
  json_key(out, ',', "watts");
  json_value(out, m.watts);
  json_key(out, ',', "charging");
  json_value(out, m.charging);
  out += '}';
}

void read(Reader& in, ChargepolicyConfig& m) {
  in.read(m.enable_input);
  in.read(m.enable_output);
}

void write(Writer& out, const ChargepolicyConfig& m) {
  out.write(m.enable_input);
  out.write(m.enable_output);
}

void to_json(std::string& out, const ChargepolicyConfig& m) {
  json_key(out, '{', "enable_input");
  json_value(out, m.enable_input);
  json_key(out, ',', "enable_output");
  json_value(out, m.enable_output);
  out += '}';
}

const MessageDef kRows[2] = {
    {2, MessageType::kData, kDataState, "power.data.state", "power::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {2, MessageType::kReq, kReqSetChargingPolicy, "power.req.set_charging_policy", "power::ChargepolicyConfig", true, Policy::kNone,
     check_optional<ChargepolicyConfig>, reencode<ChargepolicyConfig>, body_to_json<ChargepolicyConfig>},
};

}  // namespace playhouse::wire::power
