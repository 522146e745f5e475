// Generated from interfaces/056_rfid.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/rfid.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::rfid {

void read(Reader& in, Tag& m) {
  in.read(m.type);
  std::uint32_t guid_count = 0;
  in.read(guid_count);
  in.read_bytes(m.guid, in.dynamic_length("guid", guid_count, 1));
}

void write(Writer& out, const Tag& m) {
  out.write(m.type);
  out.write_length("guid", m.guid.size(), 33554392);
  out.write_length("guid", m.guid.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.guid)));
}

void to_json(std::string& out, const Tag& m) {
  json_key(out, '{', "type");
  json_value(out, m.type);
  json_key(out, ',', "guid");
  json_text(out, m.guid);
  out += '}';
}

void read(Reader& in, Data& m) {
  std::uint32_t tags_count = 0;
  in.read(tags_count);
  m.tags.resize(in.dynamic_length("tags", tags_count, 12));
  for (auto& element : m.tags) read(in, element);
}

void write(Writer& out, const Data& m) {
  out.write_length("tags", m.tags.size(), 2796199);
  out.write_length("tags", m.tags.size(), 2796199);
  for (const auto& element : m.tags) write(out, element);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "tags");
  json_array(out, m.tags, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

const MessageDef kRows[5] = {
    {56, MessageType::kData, kDataTags, "rfid.data.tags", "rfid::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {56, MessageType::kReq, kReqPower, "rfid.req.power", "", false, Policy::kNone,
     check_nothing, reencode_nothing, nothing_to_json},
    {56, MessageType::kReq, kReqReadtag, "rfid.req.readtag", "", false, Policy::kNone,
     check_nothing, reencode_nothing, nothing_to_json},
    {56, MessageType::kReq, kReqWritetag, "rfid.req.writetag", "", false, Policy::kNone,
     check_nothing, reencode_nothing, nothing_to_json},
    {56, MessageType::kReq, kReqLocktag, "rfid.req.locktag", "", false, Policy::kNone,
     check_nothing, reencode_nothing, nothing_to_json},
};

}  // namespace playhouse::wire::rfid
