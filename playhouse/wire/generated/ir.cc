// Generated from interfaces/022_ir.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/ir.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::ir {

void read(Reader& in, Data& m) {
  std::uint32_t voltages_count = 0;
  in.read(voltages_count);
  in.read_numbers(m.voltages, in.dynamic_length("voltages", voltages_count, 4));
  std::uint32_t ranges_count = 0;
  in.read(ranges_count);
  in.read_numbers(m.ranges, in.dynamic_length("ranges", ranges_count, 4));
}

void write(Writer& out, const Data& m) {
  out.write_length("voltages", m.voltages.size(), 8388598);
  out.write_length("voltages", m.voltages.size(), 8388598);
  out.write_numbers(m.voltages);
  out.write_length("ranges", m.ranges.size(), 8388598);
  out.write_length("ranges", m.ranges.size(), 8388598);
  out.write_numbers(m.ranges);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "voltages");
  json_array(out, m.voltages, [](std::string& to, const auto& e) { json_value(to, e); });
  json_key(out, ',', "ranges");
  json_array(out, m.ranges, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, Pose& m) {
  std::uint32_t poses_count = 0;
  in.read(poses_count);
  m.poses.resize(in.dynamic_length("poses", poses_count, 48));
  for (auto& element : m.poses) read(in, element);
}

void write(Writer& out, const Pose& m) {
  out.write_length("poses", m.poses.size(), 699049);
  out.write_length("poses", m.poses.size(), 699049);
  for (const auto& element : m.poses) write(out, element);
}

void to_json(std::string& out, const Pose& m) {
  json_key(out, '{', "poses");
  json_array(out, m.poses, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, PowerReq& m) {
  in.read(m.state);
}

void write(Writer& out, const PowerReq& m) {
  out.write(m.state);
}

void to_json(std::string& out, const PowerReq& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

const MessageDef kRows[3] = {
    {22, MessageType::kData, kDataRanges, "ir.data.ranges", "ir::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {22, MessageType::kReq, kReqPose, "ir.req.pose", "ir::Pose", true, Policy::kNone,
     check_optional<Pose>, reencode<Pose>, body_to_json<Pose>},
    {22, MessageType::kReq, kReqPower, "ir.req.power", "ir::PowerReq", true, Policy::kNone,
     check_optional<PowerReq>, reencode<PowerReq>, body_to_json<PowerReq>},
};

}  // namespace playhouse::wire::ir
