// Generated from interfaces/051_opaque.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/opaque.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::opaque {

void read(Reader& in, Data& m) {
  std::uint32_t data_count = 0;
  in.read(data_count);
  in.read_bytes(m.data, in.dynamic_length("data", data_count, 1));
}

void write(Writer& out, const Data& m) {
  out.write_length("data", m.data.size(), 33554392);
  out.write_length("data", m.data.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.data)));
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "data");
  json_bytes(out, m.data);
  out += '}';
}

const MessageDef kRows[3] = {
    {51, MessageType::kData, kDataState, "opaque.data.state", "opaque::Data", true, Policy::kQueue,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {51, MessageType::kCmd, kCmdData, "opaque.cmd.data", "opaque::Data", true, Policy::kQueue,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {51, MessageType::kReq, kReqData, "opaque.req.data", "opaque::Data", true, Policy::kNone,
     check_optional<Data>, reencode<Data>, body_to_json<Data>},
};

}  // namespace playhouse::wire::opaque
