// Generated from interfaces/059_health.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/health.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::health {

void read(Reader& in, Cpu& m) {
  in.read(m.idle);
  in.read(m.system);
  in.read(m.user);
}

void write(Writer& out, const Cpu& m) {
  out.write(m.idle);
  out.write(m.system);
  out.write(m.user);
}

void to_json(std::string& out, const Cpu& m) {
  json_key(out, '{', "idle");
  json_value(out, m.idle);
  json_key(out, ',', "system");
  json_value(out, m.system);
  json_key(out, ',', "user");
  json_value(out, m.user);
  out += '}';
}

void read(Reader& in, Memory& m) {
  in.read(m.total);
  in.read(m.used);
  in.read(m.free);
}

void write(Writer& out, const Memory& m) {
  out.write(m.total);
  out.write(m.used);
  out.write(m.free);
}

void to_json(std::string& out, const Memory& m) {
  json_key(out, '{', "total");
  json_value(out, m.total);
  json_key(out, ',', "used");
  json_value(out, m.used);
  json_key(out, ',', "free");
  json_value(out, m.free);
  out += '}';
}

void read(Reader& in, Data& m) {
  read(in, m.cpu_usage);
  read(in, m.mem);
  read(in, m.swap);
}

void write(Writer& out, const Data& m) {
  write(out, m.cpu_usage);
  write(out, m.mem);
  write(out, m.swap);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "cpu_usage");
  to_json(out, m.cpu_usage);
  json_key(out, ',', "mem");
  to_json(out, m.mem);
  json_key(out, ',', "swap");
  to_json(out, m.swap);
  out += '}';
}

const MessageDef kRows[1] = {
    {59, MessageType::kData, kDataState, "health.data.state", "health::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
};

}  // namespace playhouse::wire::health
