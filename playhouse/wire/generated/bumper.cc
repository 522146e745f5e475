// Generated from interfaces/014_bumper.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/bumper.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::bumper {

void read(Reader& in, Data& m) {
  std::uint32_t bumpers_count = 0;
  in.read(bumpers_count);
  in.read_bytes(m.bumpers, in.dynamic_length("bumpers", bumpers_count, 1));
}

void write(Writer& out, const Data& m) {
  out.write_length("bumpers", m.bumpers.size(), 33554392);
  out.write_length("bumpers", m.bumpers.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.bumpers)));
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "bumpers");
  json_bytes(out, m.bumpers);
  out += '}';
}

void read(Reader& in, Define& m) {
  read(in, m.pose);
  in.read(m.length);
  in.read(m.radius);
}

void write(Writer& out, const Define& m) {
  write(out, m.pose);
  out.write(m.length);
  out.write(m.radius);
}

void to_json(std::string& out, const Define& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "length");
  json_value(out, m.length);
  json_key(out, ',', "radius");
  json_value(out, m.radius);
  out += '}';
}

void read(Reader& in, Geom& m) {
  std::uint32_t bumper_def_count = 0;
  in.read(bumper_def_count);
  m.bumper_def.resize(in.dynamic_length("bumper_def", bumper_def_count, 56));
  for (auto& element : m.bumper_def) read(in, element);
}

void write(Writer& out, const Geom& m) {
  out.write_length("bumper_def", m.bumper_def.size(), 599185);
  out.write_length("bumper_def", m.bumper_def.size(), 599185);
  for (const auto& element : m.bumper_def) write(out, element);
}

void to_json(std::string& out, const Geom& m) {
  json_key(out, '{', "bumper_def");
  json_array(out, m.bumper_def, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

const MessageDef kRows[3] = {
    {14, MessageType::kData, kDataState, "bumper.data.state", "bumper::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {14, MessageType::kData, kDataGeom, "bumper.data.geom", "bumper::Geom", true, Policy::kLatest,
     check_required<Geom>, reencode<Geom>, body_to_json<Geom>},
    {14, MessageType::kReq, kReqGetGeom, "bumper.req.get_geom", "bumper::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
};

}  // namespace playhouse::wire::bumper
