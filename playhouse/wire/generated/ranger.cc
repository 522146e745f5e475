// Generated from interfaces/062_ranger.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/ranger.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::ranger {

void read(Reader& in, Config& m) {
  in.read(m.min_angle);
  in.read(m.max_angle);
  in.read(m.angular_res);
  in.read(m.min_range);
  in.read(m.max_range);
  in.read(m.range_res);
  in.read(m.frequency);
}

void write(Writer& out, const Config& m) {
  out.write(m.min_angle);
  out.write(m.max_angle);
  out.write(m.angular_res);
  out.write(m.min_range);
  out.write(m.max_range);
  out.write(m.range_res);
  out.write(m.frequency);
}

void to_json(std::string& out, const Config& m) {
  json_key(out, '{', "min_angle");
  json_value(out, m.min_angle);
  json_key(out, ',', "max_angle");
  json_value(out, m.max_angle);
  json_key(out, ',', "angular_res");
  json_value(out, m.angular_res);
  json_key(out, ',', "min_range");
  json_value(out, m.min_range);
  json_key(out, ',', "max_range");
  json_value(out, m.max_range);
  json_key(out, ',', "range_res");
  json_value(out, m.range_res);
  json_key(out, ',', "frequency");
  json_value(out, m.frequency);
  out += '}';
}

void read(Reader& in, Geom& m) {
  read(in, m.pose);
  read(in, m.size);
  std::uint32_t element_poses_count = 0;
  in.read(element_poses_count);
  m.element_poses.resize(in.dynamic_length("element_poses", element_poses_count, 48));
  for (auto& element : m.element_poses) read(in, element);
  std::uint32_t element_sizes_count = 0;
  in.read(element_sizes_count);
  m.element_sizes.resize(in.dynamic_length("element_sizes", element_sizes_count, 24));
  for (auto& element : m.element_sizes) read(in, element);
}

void write(Writer& out, const Geom& m) {
  write(out, m.pose);
  write(out, m.size);
  out.write_length("element_poses", m.element_poses.size(), 699049);
  out.write_length("element_poses", m.element_poses.size(), 699049);
  for (const auto& element : m.element_poses) write(out, element);
  out.write_length("element_sizes", m.element_sizes.size(), 1398099);
  out.write_length("element_sizes", m.element_sizes.size(), 1398099);
  for (const auto& element : m.element_sizes) write(out, element);
}

void to_json(std::string& out, const Geom& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "size");
  to_json(out, m.size);
  json_key(out, ',', "element_poses");
  json_array(out, m.element_poses, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "element_sizes");
  json_array(out, m.element_sizes, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, DataRange& m) {
  std::uint32_t ranges_count = 0;
  in.read(ranges_count);
  in.read_numbers(m.ranges, in.dynamic_length("ranges", ranges_count, 8));
}

void write(Writer& out, const DataRange& m) {
  out.write_length("ranges", m.ranges.size(), 4194299);
  out.write_length("ranges", m.ranges.size(), 4194299);
  out.write_numbers(m.ranges);
}

void to_json(std::string& out, const DataRange& m) {
  json_key(out, '{', "ranges");
  json_array(out, m.ranges, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, DataRangestamped& m) {
  read(in, m.data);
  in.read(m.have_geom);
  read(in, m.geom);
  in.read(m.have_config);
  read(in, m.config);
}

void write(Writer& out, const DataRangestamped& m) {
  write(out, m.data);
  out.write(m.have_geom);
  write(out, m.geom);
  out.write(m.have_config);
  write(out, m.config);
}

void to_json(std::string& out, const DataRangestamped& m) {
  json_key(out, '{', "data");
  to_json(out, m.data);
  json_key(out, ',', "have_geom");
  json_value(out, m.have_geom);
  json_key(out, ',', "geom");
  to_json(out, m.geom);
  json_key(out, ',', "have_config");
  json_value(out, m.have_config);
  json_key(out, ',', "config");
  to_json(out, m.config);
  out += '}';
}

void read(Reader& in, DataIntns& m) {
  std::uint32_t intensities_count = 0;
  in.read(intensities_count);
  in.read_numbers(m.intensities, in.dynamic_length("intensities", intensities_count, 8));
}

void write(Writer& out, const DataIntns& m) {
  out.write_length("intensities", m.intensities.size(), 4194299);
  out.write_length("intensities", m.intensities.size(), 4194299);
  out.write_numbers(m.intensities);
}

void to_json(std::string& out, const DataIntns& m) {
  json_key(out, '{', "intensities");
  json_array(out, m.intensities, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, DataIntnsstamped& m) {
  read(in, m.data);
  in.read(m.have_geom);
  read(in, m.geom);
  in.read(m.have_config);
  read(in, m.config);
}

void write(Writer& out, const DataIntnsstamped& m) {
  write(out, m.data);
  out.write(m.have_geom);
  write(out, m.geom);
  out.write(m.have_config);
  write(out, m.config);
}

void to_json(std::string& out, const DataIntnsstamped& m) {
  json_key(out, '{', "data");
  to_json(out, m.data);
  json_key(out, ',', "have_geom");
  json_value(out, m.have_geom);
  json_key(out, ',', "geom");
  to_json(out, m.geom);
  json_key(out, ',', "have_config");
  json_value(out, m.have_config);
  json_key(out, ',', "config");
  to_json(out, m.config);
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

void read(Reader& in, IntnsConfig& m) {
  in.read(m.state);
}

void write(Writer& out, const IntnsConfig& m) {
  out.write(m.state);
}

void to_json(std::string& out, const IntnsConfig& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

const MessageDef kRows[10] = {
    {62, MessageType::kData, kDataRange, "ranger.data.range", "ranger::DataRange", true, Policy::kLatest,
     check_required<DataRange>, reencode<DataRange>, body_to_json<DataRange>},
    {62, MessageType::kData, kDataRangestamped, "ranger.data.rangestamped", "ranger::DataRangestamped", true, Policy::kLatest,
     check_required<DataRangestamped>, reencode<DataRangestamped>, body_to_json<DataRangestamped>},
    {62, MessageType::kData, kDataIntns, "ranger.data.intns", "ranger::DataIntns", true, Policy::kLatest,
     check_required<DataIntns>, reencode<DataIntns>, body_to_json<DataIntns>},
    {62, MessageType::kData, kDataIntnsstamped, "ranger.data.intnsstamped", "ranger::DataIntnsstamped", true, Policy::kLatest,
     check_required<DataIntnsstamped>, reencode<DataIntnsstamped>, body_to_json<DataIntnsstamped>},
    {62, MessageType::kData, kDataGeom, "ranger.data.geom", "ranger::Geom", true, Policy::kLatest,
     check_required<Geom>, reencode<Geom>, body_to_json<Geom>},
    {62, MessageType::kReq, kReqGetGeom, "ranger.req.get_geom", "ranger::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
    {62, MessageType::kReq, kReqPower, "ranger.req.power", "ranger::PowerConfig", true, Policy::kNone,
     check_optional<PowerConfig>, reencode<PowerConfig>, body_to_json<PowerConfig>},
    {62, MessageType::kReq, kReqIntns, "ranger.req.intns", "ranger::IntnsConfig", true, Policy::kNone,
     check_optional<IntnsConfig>, reencode<IntnsConfig>, body_to_json<IntnsConfig>},
    {62, MessageType::kReq, kReqSetConfig, "ranger.req.set_config", "ranger::Config", true, Policy::kNone,
     check_optional<Config>, reencode<Config>, body_to_json<Config>},
    {62, MessageType::kReq, kReqGetConfig, "ranger.req.get_config", "ranger::Config", true, Policy::kNone,
     check_optional<Config>, reencode<Config>, body_to_json<Config>},
};

}  // namespace playhouse::wire::ranger
