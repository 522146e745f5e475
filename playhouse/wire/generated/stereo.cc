// Generated from interfaces/065_stereo.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/stereo.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::stereo {

void read(Reader& in, Pointcloud3dStereoElement& m) {
  in.read(m.px);
  in.read(m.py);
  in.read(m.pz);
  in.read(m.red);
  in.read(m.green);
  in.read(m.blue);
}

void write(Writer& out, const Pointcloud3dStereoElement& m) {
  out.write(m.px);
  out.write(m.py);
  out.write(m.pz);
  out.write(m.red);
  out.write(m.green);
  out.write(m.blue);
}

void to_json(std::string& out, const Pointcloud3dStereoElement& m) {
  json_key(out, '{', "px");
  json_value(out, m.px);
  json_key(out, ',', "py");
  json_value(out, m.py);
  json_key(out, ',', "pz");
  json_value(out, m.pz);
  json_key(out, ',', "red");
  json_value(out, m.red);
  json_key(out, ',', "green");
  json_value(out, m.green);
  json_key(out, ',', "blue");
  json_value(out, m.blue);
  out += '}';
}

void read(Reader& in, Data& m) {
  read(in, m.left_channel);
  read(in, m.right_channel);
  read(in, m.disparity);
  std::uint32_t points_count = 0;
  in.read(points_count);
  m.points.resize(in.dynamic_length("points", points_count, 24));
  for (auto& element : m.points) read(in, element);
  in.read(m.mode);
}

void write(Writer& out, const Data& m) {
  write(out, m.left_channel);
  write(out, m.right_channel);
  write(out, m.disparity);
  out.write_length("points", m.points.size(), 1398099);
  out.write_length("points", m.points.size(), 1398099);
  for (const auto& element : m.points) write(out, element);
  out.write(m.mode);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "left_channel");
  to_json(out, m.left_channel);
  json_key(out, ',', "right_channel");
  to_json(out, m.right_channel);
  json_key(out, ',', "disparity");
  to_json(out, m.disparity);
  json_key(out, ',', "points");
  json_array(out, m.points, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "mode");
  json_value(out, m.mode);
  out += '}';
}

const MessageDef kRows[1] = {
    {65, MessageType::kData, kDataState, "stereo.data.state", "stereo::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
};

}  // namespace playhouse::wire::stereo
