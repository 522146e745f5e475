// Generated from interfaces/042_map.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/map.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::map {

void read(Reader& in, Info& m) {
  in.read(m.scale);
  in.read(m.width);
  in.read(m.height);
  read(in, m.origin);
}

void write(Writer& out, const Info& m) {
  out.write(m.scale);
  out.write(m.width);
  out.write(m.height);
  write(out, m.origin);
}

void to_json(std::string& out, const Info& m) {
  json_key(out, '{', "scale");
  json_value(out, m.scale);
  json_key(out, ',', "width");
  json_value(out, m.width);
  json_key(out, ',', "height");
  json_value(out, m.height);
  json_key(out, ',', "origin");
  to_json(out, m.origin);
  out += '}';
}

void read(Reader& in, Data& m) {
  in.read(m.col);
  in.read(m.row);
  in.read(m.width);
  in.read(m.height);
  std::uint32_t data_count = 0;
  in.read(data_count);
  in.read(m.data_range);
  in.read_bytes(m.data, in.dynamic_length("data", data_count, 1));
}

void write(Writer& out, const Data& m) {
  out.write(m.col);
  out.write(m.row);
  out.write(m.width);
  out.write(m.height);
  out.write_length("data", m.data.size(), 33554392);
  out.write(m.data_range);
  out.write_length("data", m.data.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.data)));
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "col");
  json_value(out, m.col);
  json_key(out, ',', "row");
  json_value(out, m.row);
  json_key(out, ',', "width");
  json_value(out, m.width);
  json_key(out, ',', "height");
  json_value(out, m.height);
  json_key(out, ',', "data_range");
  json_value(out, m.data_range);
  json_key(out, ',', "data");
  json_bytes(out, m.data);
  out += '}';
}

void read(Reader& in, DataVector& m) {
  in.read(m.minx);
  in.read(m.maxx);
  in.read(m.miny);
  in.read(m.maxy);
  std::uint32_t segments_count = 0;
  in.read(segments_count);
  m.segments.resize(in.dynamic_length("segments", segments_count, 32));
  for (auto& element : m.segments) read(in, element);
}

void write(Writer& out, const DataVector& m) {
  out.write(m.minx);
  out.write(m.maxx);
  out.write(m.miny);
  out.write(m.maxy);
  out.write_length("segments", m.segments.size(), 1048574);
  out.write_length("segments", m.segments.size(), 1048574);
  for (const auto& element : m.segments) write(out, element);
}

void to_json(std::string& out, const DataVector& m) {
  json_key(out, '{', "minx");
  json_value(out, m.minx);
  json_key(out, ',', "maxx");
  json_value(out, m.maxx);
  json_key(out, ',', "miny");
  json_value(out, m.miny);
  json_key(out, ',', "maxy");
  json_value(out, m.maxy);
  json_key(out, ',', "segments");
  json_array(out, m.segments, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

const MessageDef kRows[4] = {
    {42, MessageType::kData, kDataInfo, "map.data.info", "map::Info", true, Policy::kLatest,
     check_required<Info>, reencode<Info>, body_to_json<Info>},
    {42, MessageType::kReq, kReqGetInfo, "map.req.get_info", "map::Info", true, Policy::kNone,
     check_optional<Info>, reencode<Info>, body_to_json<Info>},
    {42, MessageType::kReq, kReqGetData, "map.req.get_data", "map::Data", true, Policy::kNone,
     check_optional<Data>, reencode<Data>, body_to_json<Data>},
    {42, MessageType::kReq, kReqGetVector, "map.req.get_vector", "map::DataVector", true, Policy::kNone,
     check_optional<DataVector>, reencode<DataVector>, body_to_json<DataVector>},
};

}  // namespace playhouse::wire::map
