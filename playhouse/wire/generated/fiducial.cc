// Generated from interfaces/010_fiducial.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/fiducial.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::fiducial {

void read(Reader& in, Item& m) {
  in.read(m.id);
  read(in, m.pose);
  read(in, m.upose);
}

void write(Writer& out, const Item& m) {
  out.write(m.id);
  write(out, m.pose);
  write(out, m.upose);
}

void to_json(std::string& out, const Item& m) {
  json_key(out, '{', "id");
  json_value(out, m.id);
  json_key(out, ',', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "upose");
  to_json(out, m.upose);
  out += '}';
}

void read(Reader& in, Data& m) {
  std::uint32_t fiducials_count = 0;
  in.read(fiducials_count);
  m.fiducials.resize(in.dynamic_length("fiducials", fiducials_count, 100));
  for (auto& element : m.fiducials) read(in, element);
}

void write(Writer& out, const Data& m) {
  out.write_length("fiducials", m.fiducials.size(), 335543);
  out.write_length("fiducials", m.fiducials.size(), 335543);
  for (const auto& element : m.fiducials) write(out, element);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "fiducials");
  json_array(out, m.fiducials, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, Geom& m) {
  read(in, m.pose);
  read(in, m.size);
  read(in, m.fiducial_size);
}

void write(Writer& out, const Geom& m) {
  write(out, m.pose);
  write(out, m.size);
  write(out, m.fiducial_size);
}

void to_json(std::string& out, const Geom& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "size");
  to_json(out, m.size);
  json_key(out, ',', "fiducial_size");
  to_json(out, m.fiducial_size);
  out += '}';
}

void read(Reader& in, Fov& m) {
  in.read(m.min_range);
  in.read(m.max_range);
  in.read(m.view_angle);
}

void write(Writer& out, const Fov& m) {
  out.write(m.min_range);
  out.write(m.max_range);
  out.write(m.view_angle);
}

void to_json(std::string& out, const Fov& m) {
  json_key(out, '{', "min_range");
  json_value(out, m.min_range);
  json_key(out, ',', "max_range");
  json_value(out, m.max_range);
  json_key(out, ',', "view_angle");
  json_value(out, m.view_angle);
  out += '}';
}

void read(Reader& in, Id& m) {
  in.read(m.id);
}

void write(Writer& out, const Id& m) {
  out.write(m.id);
}

void to_json(std::string& out, const Id& m) {
  json_key(out, '{', "id");
  json_value(out, m.id);
  out += '}';
}

const MessageDef kRows[6] = {
    {10, MessageType::kData, kDataScan, "fiducial.data.scan", "fiducial::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {10, MessageType::kReq, kReqGetGeom, "fiducial.req.get_geom", "fiducial::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
    {10, MessageType::kReq, kReqGetFov, "fiducial.req.get_fov", "fiducial::Fov", true, Policy::kNone,
     check_optional<Fov>, reencode<Fov>, body_to_json<Fov>},
    {10, MessageType::kReq, kReqSetFov, "fiducial.req.set_fov", "fiducial::Fov", true, Policy::kNone,
     check_optional<Fov>, reencode<Fov>, body_to_json<Fov>},
    {10, MessageType::kReq, kReqGetId, "fiducial.req.get_id", "fiducial::Id", true, Policy::kNone,
     check_optional<Id>, reencode<Id>, body_to_json<Id>},
    {10, MessageType::kReq, kReqSetId, "fiducial.req.set_id", "fiducial::Id", true, Policy::kNone,
     check_optional<Id>, reencode<Id>, body_to_json<Id>},
};

}  // namespace playhouse::wire::fiducial
