// Generated from interfaces/050_speech_recognition.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/speech_recognition.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::speech_recognition {

void read(Reader& in, Data& m) {
  std::uint32_t text_count = 0;
  in.read(text_count);
  in.read_bytes(m.text, in.dynamic_length("text", text_count, 1));
}

void write(Writer& out, const Data& m) {
  out.write_length("text", m.text.size(), 33554392);
  out.write_length("text", m.text.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.text)));
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "text");
  json_text(out, m.text);
  out += '}';
}

const MessageDef kRows[1] = {
    {50, MessageType::kData, kDataString, "speech_recognition.data.string", "speech_recognition::Data", true, Policy::kQueue,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
};

}  // namespace playhouse::wire::speech_recognition
