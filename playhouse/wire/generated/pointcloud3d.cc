// Generated from interfaces/061_pointcloud3d.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/pointcloud3d.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::pointcloud3d {

void read(Reader& in, Element& m) {
  read(in, m.point);
  read(in, m.color);
}

void write(Writer& out, const Element& m) {
  write(out, m.point);
  write(out, m.color);
}

void to_json(std::string& out, const Element& m) {
  json_key(out, '{', "point");
  to_json(out, m.point);
  json_key(out, ',', "color");
  to_json(out, m.color);
  out += '}';
}

void read(Reader& in, Data& m) {
  std::uint32_t points_count = 0;
  in.read(points_count);
  m.points.resize(in.dynamic_length("points", points_count, 40));
  for (auto& element : m.points) read(in, element);
}

void write(Writer& out, const Data& m) {
  out.write_length("points", m.points.size(), 838859);
  out.write_length("points", m.points.size(), 838859);
  for (const auto& element : m.points) write(out, element);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "points");
  json_array(out, m.points, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

const MessageDef kRows[1] = {
    {61, MessageType::kData, kDataState, "pointcloud3d.data.state", "pointcloud3d::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
};

}  // namespace playhouse::wire::pointcloud3d
