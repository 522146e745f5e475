// Generated from interfaces/049_joystick.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/joystick.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::joystick {

void read(Reader& in, Data& m) {
  for (auto& element : m.pos) in.read(element);
  for (auto& element : m.scale) in.read(element);
  in.read(m.buttons);
  in.read(m.axes_count);
}

void write(Writer& out, const Data& m) {
  for (const auto& element : m.pos) out.write(element);
  for (const auto& element : m.scale) out.write(element);
  out.write(m.buttons);
  out.write(m.axes_count);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "pos");
  json_array(out, m.pos, [](std::string& to, const auto& e) { json_value(to, e); });
  json_key(out, ',', "scale");
  json_array(out, m.scale, [](std::string& to, const auto& e) { json_value(to, e); });
  json_key(out, ',', "buttons");
  json_value(out, m.buttons);
  json_key(out, ',', "axes_count");
  json_value(out, m.axes_count);
  out += '}';
}

const MessageDef kRows[1] = {
    {49, MessageType::kData, kDataState, "joystick.data.state", "joystick::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
};

}  // namespace playhouse::wire::joystick
