// Generated from interfaces/005_sonar.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/sonar.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::sonar {

void read(Reader& in, Data& m) {
  std::uint32_t ranges_count = 0;
  in.read(ranges_count);
  in.read_numbers(m.ranges, in.dynamic_length("ranges", ranges_count, 4));
}

void write(Writer& out, const Data& m) {
  out.write_length("ranges", m.ranges.size(), 8388598);
  out.write_length("ranges", m.ranges.size(), 8388598);
  out.write_numbers(m.ranges);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "ranges");
  json_array(out, m.ranges, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, Geom& m) {
  std::uint32_t poses_count = 0;
  in.read(poses_count);
  m.poses.resize(in.dynamic_length("poses", poses_count, 48));
  for (auto& element : m.poses) read(in, element);
}

void write(Writer& out, const Geom& m) {
  out.write_length("poses", m.poses.size(), 699049);
  out.write_length("poses", m.poses.size(), 699049);
  for (const auto& element : m.poses) write(out, element);
}

void to_json(std::string& out, const Geom& m) {
  json_key(out, '{', "poses");
  json_array(out, m.poses, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, PowerConfig& m) {
  in.read(m.state);
}

void write(Writer& out, const PowerConfig& m) {
  out.write(m.state);
}

void to_json(std::string& out, const PowerConfig& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

const MessageDef kRows[4] = {
    {5, MessageType::kData, kDataRanges, "sonar.data.ranges", "sonar::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {5, MessageType::kData, kDataGeom, "sonar.data.geom", "sonar::Geom", true, Policy::kLatest,
     check_required<Geom>, reencode<Geom>, body_to_json<Geom>},
    {5, MessageType::kReq, kReqGetGeom, "sonar.req.get_geom", "sonar::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
    {5, MessageType::kReq, kReqPower, "sonar.req.power", "sonar::PowerConfig", true, Policy::kNone,
     check_optional<PowerConfig>, reencode<PowerConfig>, body_to_json<PowerConfig>},
};

}  // namespace playhouse::wire::sonar
