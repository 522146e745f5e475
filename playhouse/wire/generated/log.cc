// Generated from interfaces/045_log.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/log.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::log {

void read(Reader& in, SetWriteState& m) {
  in.read(m.state);
}

void write(Writer& out, const SetWriteState& m) {
  out.write(m.state);
}

void to_json(std::string& out, const SetWriteState& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, SetReadState& m) {
  in.read(m.state);
}

void write(Writer& out, const SetReadState& m) {
  out.write(m.state);
}

void to_json(std::string& out, const SetReadState& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, GetState& m) {
  in.read(m.type);
  in.read(m.state);
}

void write(Writer& out, const GetState& m) {
  out.write(m.type);
  out.write(m.state);
}

void to_json(std::string& out, const GetState& m) {
  json_key(out, '{', "type");
  json_value(out, m.type);
  json_key(out, ',', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, SetFilename& m) {
  std::uint32_t filename_count = 0;
  in.read(filename_count);
  in.read_bytes(m.filename, in.counted_length("filename", 256, 1));
}

void write(Writer& out, const SetFilename& m) {
  out.write_length("filename", m.filename.size(), 256);
  out.write_length("filename", m.filename.size(), 256);
  out.write_bytes(std::as_bytes(std::span(m.filename)));
}

void to_json(std::string& out, const SetFilename& m) {
  json_key(out, '{', "filename");
  json_text(out, m.filename);
  out += '}';
}

const MessageDef kRows[5] = {
    {45, MessageType::kReq, kReqSetWriteState, "log.req.set_write_state", "log::SetWriteState", true, Policy::kNone,
     check_optional<SetWriteState>, reencode<SetWriteState>, body_to_json<SetWriteState>},
    {45, MessageType::kReq, kReqSetReadState, "log.req.set_read_state", "log::SetReadState", true, Policy::kNone,
     check_optional<SetReadState>, reencode<SetReadState>, body_to_json<SetReadState>},
    {45, MessageType::kReq, kReqGetState, "log.req.get_state", "log::GetState", true, Policy::kNone,
     check_optional<GetState>, reencode<GetState>, body_to_json<GetState>},
    {45, MessageType::kReq, kReqSetReadRewind, "log.req.set_read_rewind", "", false, Policy::kNone,
     check_nothing, reencode_nothing, nothing_to_json},
    {45, MessageType::kReq, kReqSetFilename, "log.req.set_filename", "log::SetFilename", true, Policy::kNone,
     check_optional<SetFilename>, reencode<SetFilename>, body_to_json<SetFilename>},
};

}  // namespace playhouse::wire::log
