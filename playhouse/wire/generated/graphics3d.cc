// Generated from interfaces/058_graphics3d.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/graphics3d.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::graphics3d {

void read(Reader& in, CmdDraw& m) {
  in.read(m.draw_mode);
  std::uint32_t points_count = 0;
  in.read(points_count);
  m.points.resize(in.dynamic_length("points", points_count, 24));
  for (auto& element : m.points) read(in, element);
  read(in, m.color);
}

void write(Writer& out, const CmdDraw& m) {
  out.write(m.draw_mode);
  out.write_length("points", m.points.size(), 1398099);
  out.write_length("points", m.points.size(), 1398099);
  for (const auto& element : m.points) write(out, element);
  write(out, m.color);
}

void to_json(std::string& out, const CmdDraw& m) {
  json_key(out, '{', "draw_mode");
  json_value(out, m.draw_mode);
  json_key(out, ',', "points");
  json_array(out, m.points, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "color");
  to_json(out, m.color);
  out += '}';
}

void read(Reader& in, CmdTranslate& m) {
  in.read(m.x);
  in.read(m.y);
  in.read(m.z);
}

void write(Writer& out, const CmdTranslate& m) {
  out.write(m.x);
  out.write(m.y);
  out.write(m.z);
}

void to_json(std::string& out, const CmdTranslate& m) {
  json_key(out, '{', "x");
  json_value(out, m.x);
  json_key(out, ',', "y");
  json_value(out, m.y);
  json_key(out, ',', "z");
  json_value(out, m.z);
  out += '}';
}

void read(Reader& in, CmdRotate& m) {
  in.read(m.a);
  in.read(m.x);
  in.read(m.y);
  in.read(m.z);
}

void write(Writer& out, const CmdRotate& m) {
  out.write(m.a);
  out.write(m.x);
  out.write(m.y);
  out.write(m.z);
}

void to_json(std::string& out, const CmdRotate& m) {
  json_key(out, '{', "a");
  json_value(out, m.a);
  json_key(out, ',', "x");
  json_value(out, m.x);
  json_key(out, ',', "y");
  json_value(out, m.y);
  json_key(out, ',', "z");
  json_value(out, m.z);
  out += '}';
}

const MessageDef kRows[6] = {
    {58, MessageType::kCmd, kCmdClear, "graphics3d.cmd.clear", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {58, MessageType::kCmd, kCmdDraw, "graphics3d.cmd.draw", "graphics3d::CmdDraw", true, Policy::kQueue,
     check_required<CmdDraw>, reencode<CmdDraw>, body_to_json<CmdDraw>},
    {58, MessageType::kCmd, kCmdTranslate, "graphics3d.cmd.translate", "graphics3d::CmdTranslate", true, Policy::kQueue,
     check_required<CmdTranslate>, reencode<CmdTranslate>, body_to_json<CmdTranslate>},
    {58, MessageType::kCmd, kCmdRotate, "graphics3d.cmd.rotate", "graphics3d::CmdRotate", true, Policy::kQueue,
     check_required<CmdRotate>, reencode<CmdRotate>, body_to_json<CmdRotate>},
    {58, MessageType::kCmd, kCmdPush, "graphics3d.cmd.push", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
    {58, MessageType::kCmd, kCmdPop, "graphics3d.cmd.pop", "", false, Policy::kQueue,
     check_nothing, reencode_nothing, nothing_to_json},
};

}  // namespace playhouse::wire::graphics3d
