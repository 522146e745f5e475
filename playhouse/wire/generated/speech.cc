// Generated from interfaces/012_speech.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/speech.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::speech {

void read(Reader& in, Cmd& m) {
  std::uint32_t string_count = 0;
  in.read(string_count);
  in.read_bytes(m.string, in.dynamic_length("string", string_count, 1));
}

void write(Writer& out, const Cmd& m) {
  out.write_length("string", m.string.size(), 33554392);
  out.write_length("string", m.string.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.string)));
}

void to_json(std::string& out, const Cmd& m) {
  json_key(out, '{', "string");
  json_text(out, m.string);
  out += '}';
}

const MessageDef kRows[1] = {
    {12, MessageType::kCmd, kCmdSay, "speech.cmd.say", "speech::Cmd", true, Policy::kQueue,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
};

}  // namespace playhouse::wire::speech
