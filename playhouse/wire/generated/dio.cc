// Generated from interfaces/020_dio.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/dio.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::dio {

void read(Reader& in, Data& m) {
  in.read(m.count);
  in.read(m.bits);
}

void write(Writer& out, const Data& m) {
  out.write(m.count);
  out.write(m.bits);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "count");
  json_value(out, m.count);
  json_key(out, ',', "bits");
  json_value(out, m.bits);
  out += '}';
}

void read(Reader& in, Cmd& m) {
  in.read(m.count);
  in.read(m.digout);
}

void write(Writer& out, const Cmd& m) {
  out.write(m.count);
  out.write(m.digout);
}

void to_json(std::string& out, const Cmd& m) {
  json_key(out, '{', "count");
  json_value(out, m.count);
  json_key(out, ',', "digout");
  json_value(out, m.digout);
  out += '}';
}

const MessageDef kRows[2] = {
    {20, MessageType::kData, kDataValues, "dio.data.values", "dio::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {20, MessageType::kCmd, kCmdValues, "dio.cmd.values", "dio::Cmd", true, Policy::kLatest,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
};

}  // namespace playhouse::wire::dio
