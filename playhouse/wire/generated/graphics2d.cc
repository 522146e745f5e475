// Generated from interfaces/055_graphics2d.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/graphics2d.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::graphics2d {

void read(Reader& in, CmdPoints& m) {
  std::uint32_t points_count = 0;
  in.read(points_count);
  m.points.resize(in.dynamic_length("points", points_count, 16));
  for (auto& element : m.points) read(in, element);
  read(in, m.color);
}

void write(Writer& out, const CmdPoints& m) {
  out.write_length("points", m.points.size(), 2097149);
  out.write_length("points", m.points.size(), 2097149);
  for (const auto& element : m.points) write(out, element);
  write(out, m.color);
}

void to_json(std::string& out, const CmdPoints& m) {
  json_key(out, '{', "points");
  json_array(out, m.points, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "color");
  to_json(out, m.color);
  out += '}';
}

void read(Reader& in, CmdPolyline& m) {
  std::uint32_t points_count = 0;
  in.read(points_count);
  m.points.resize(in.dynamic_length("points", points_count, 16));
  for (auto& element : m.points) read(in, element);
  read(in, m.color);
}

void write(Writer& out, const CmdPolyline& m) {
  out.write_length("points", m.points.size(), 2097149);
  out.write_length("points", m.points.size(), 2097149);
  for (const auto& element : m.points) write(out, element);
  write(out, m.color);
}

void to_json(std::string& out, const CmdPolyline& m) {
  json_key(out, '{', "points");
  json_array(out, m.points, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "color");
  to_json(out, m.color);
  out += '}';
}

void read(Reader& in, CmdPolygon& m) {
  std::uint32_t points_count = 0;
  in.read(points_count);
  m.points.resize(in.dynamic_length("points", points_count, 16));
  for (auto& element : m.points) read(in, element);
  read(in, m.color);
  read(in, m.fill_color);
  in.read(m.filled);
}

void write(Writer& out, const CmdPolygon& m) {
  out.write_length("points", m.points.size(), 2097149);
  out.write_length("points", m.points.size(), 2097149);
  for (const auto& element : m.points) write(out, element);
  write(out, m.color);
  write(out, m.fill_color);
  out.write(m.filled);
}

void to_json(std::string& out, const CmdPolygon& m) {
  json_key(out, '{', "points");
  json_array(out, m.points, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "color");
  to_json(out, m.color);
  json_key(out, ',', "fill_color");
  to_json(out, m.fill_color);
  json_key(out, ',', "filled");
  json_value(out, m.filled);
  out += '}';
}

void read(Reader& in, CmdMultiline& m) {
  std::uint32_t points_count = 0;
  in.read(points_count);
  m.points.resize(in.dynamic_length("points", points_count, 16));
  for (auto& element : m.points) read(in, element);
  read(in, m.color);
}

void write(Writer& out, const CmdMultiline& m) {
  out.write_length("points", m.points.size(), 2097149);
  out.write_length("points", m.points.size(), 2097149);
  for (const auto& element : m.points) write(out, element);
  write(out, m.color);
}

void to_json(std::string& out, const CmdMultiline& m) {
  json_key(out, '{', "points");
  json_array(out, m.points, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "color");
  to_json(out, m.color);
  out += '}';
}

const MessageDef kRows[5] = {
    {55, MessageType::kCmd, kCmdClear, "graphics2d.cmd.clear", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {55, MessageType::kCmd, kCmdPoints, "graphics2d.cmd.points", "graphics2d::CmdPoints", true, Policy::kQueue,
     check_required<CmdPoints>, reencode<CmdPoints>, body_to_json<CmdPoints>},
    {55, MessageType::kCmd, kCmdPolyline, "graphics2d.cmd.polyline", "graphics2d::CmdPolyline", true, Policy::kQueue,
     check_required<CmdPolyline>, reencode<CmdPolyline>, body_to_json<CmdPolyline>},
    {55, MessageType::kCmd, kCmdPolygon, "graphics2d.cmd.polygon", "graphics2d::CmdPolygon", true, Policy::kQueue,
     check_required<CmdPolygon>, reencode<CmdPolygon>, body_to_json<CmdPolygon>},
    {55, MessageType::kCmd, kCmdMultiline, "graphics2d.cmd.multiline", "graphics2d::CmdMultiline", true, Policy::kQueue,
     check_required<CmdMultiline>, reencode<CmdMultiline>, body_to_json<CmdMultiline>},
};

}  // namespace playhouse::wire::graphics2d
