// Generated from interfaces/006_laser.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/laser.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::laser {

void read(Reader& in, Data& m) {
  in.read(m.min_angle);
  in.read(m.max_angle);
  in.read(m.resolution);
  in.read(m.max_range);
  std::uint32_t ranges_count = 0;
  in.read(ranges_count);
  in.read_numbers(m.ranges, in.dynamic_length("ranges", ranges_count, 4));
  std::uint32_t intensity_count = 0;
  in.read(intensity_count);
  in.read_bytes(m.intensity, in.dynamic_length("intensity", intensity_count, 1));
  in.read(m.id);
}

void write(Writer& out, const Data& m) {
  out.write(m.min_angle);
  out.write(m.max_angle);
  out.write(m.resolution);
  out.write(m.max_range);
  out.write_length("ranges", m.ranges.size(), 8388598);
  out.write_length("ranges", m.ranges.size(), 8388598);
  out.write_numbers(m.ranges);
  out.write_length("intensity", m.intensity.size(), 33554392);
  out.write_length("intensity", m.intensity.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.intensity)));
  out.write(m.id);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "min_angle");
  json_value(out, m.min_angle);
  json_key(out, ',', "max_angle");
  json_value(out, m.max_angle);
  json_key(out, ',', "resolution");
  json_value(out, m.resolution);
  json_key(out, ',', "max_range");
  json_value(out, m.max_range);
  json_key(out, ',', "ranges");
  json_array(out, m.ranges, [](std::string& to, const auto& e) { json_value(to, e); });
  json_key(out, ',', "intensity");
  json_bytes(out, m.intensity);
  json_key(out, ',', "id");
  json_value(out, m.id);
  out += '}';
}

void read(Reader& in, DataScanpose& m) {
  read(in, m.scan);
  read(in, m.pose);
}

void write(Writer& out, const DataScanpose& m) {
  write(out, m.scan);
  write(out, m.pose);
}

void to_json(std::string& out, const DataScanpose& m) {
  json_key(out, '{', "scan");
  to_json(out, m.scan);
  json_key(out, ',', "pose");
  to_json(out, m.pose);
  out += '}';
}

void read(Reader& in, DataScanangle& m) {
  in.read(m.max_range);
  std::uint32_t ranges_count = 0;
  in.read(ranges_count);
  in.read_numbers(m.ranges, in.dynamic_length("ranges", ranges_count, 4));
  std::uint32_t angles_count = 0;
  in.read(angles_count);
  in.read_numbers(m.angles, in.dynamic_length("angles", angles_count, 4));
  std::uint32_t intensity_count = 0;
  in.read(intensity_count);
  in.read_bytes(m.intensity, in.dynamic_length("intensity", intensity_count, 1));
  in.read(m.id);
}

void write(Writer& out, const DataScanangle& m) {
  out.write(m.max_range);
  out.write_length("ranges", m.ranges.size(), 8388598);
  out.write_length("ranges", m.ranges.size(), 8388598);
  out.write_numbers(m.ranges);
  out.write_length("angles", m.angles.size(), 8388598);
  out.write_length("angles", m.angles.size(), 8388598);
  out.write_numbers(m.angles);
  out.write_length("intensity", m.intensity.size(), 33554392);
  out.write_length("intensity", m.intensity.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.intensity)));
  out.write(m.id);
}

void to_json(std::string& out, const DataScanangle& m) {
  json_key(out, '{', "max_range");
  json_value(out, m.max_range);
  json_key(out, ',', "ranges");
  json_array(out, m.ranges, [](std::string& to, const auto& e) { json_value(to, e); });
  json_key(out, ',', "angles");
  json_array(out, m.angles, [](std::string& to, const auto& e) { json_value(to, e); });
  json_key(out, ',', "intensity");
  json_bytes(out, m.intensity);
  json_key(out, ',', "id");
  json_value(out, m.id);
  out += '}';
}

void read(Reader& in, Geom& m) {
  read(in, m.pose);
  read(in, m.size);
}

void write(Writer& out, const Geom& m) {
  write(out, m.pose);
  write(out, m.size);
}

void to_json(std::string& out, const Geom& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "size");
  to_json(out, m.size);
  out += '}';
}

void read(Reader& in, Config& m) {
  in.read(m.min_angle);
  in.read(m.max_angle);
  in.read(m.resolution);
  in.read(m.max_range);
  in.read(m.range_res);
  in.read(m.intensity);
  in.read(m.scanning_frequency);
}

void write(Writer& out, const Config& m) {
  out.write(m.min_angle);
  out.write(m.max_angle);
  out.write(m.resolution);
  out.write(m.max_range);
  out.write(m.range_res);
  out.write(m.intensity);
  out.write(m.scanning_frequency);
}

void to_json(std::string& out, const Config& m) {
  json_key(out, '{', "min_angle");
  json_value(out, m.min_angle);
  json_key(out, ',', "max_angle");
  json_value(out, m.max_angle);
  json_key(out, ',', "resolution");
  json_value(out, m.resolution);
  json_key(out, ',', "max_range");
  json_value(out, m.max_range);
  json_key(out, ',', "range_res");
  json_value(out, m.range_res);
  json_key(out, ',', "intensity");
  json_value(out, m.intensity);
  json_key(out, ',', "scanning_frequency");
  json_value(out, m.scanning_frequency);
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

void read(Reader& in, GetIdConfig& m) {
  in.read(m.serial_number);
}

void write(Writer& out, const GetIdConfig& m) {
  out.write(m.serial_number);
}

void to_json(std::string& out, const GetIdConfig& m) {
  json_key(out, '{', "serial_number");
  json_value(out, m.serial_number);
  out += '}';
}

void read(Reader& in, SetFilterConfig& m) {
  in.read(m.filter_type);
  std::uint32_t parameters_count = 0;
  in.read(parameters_count);
  in.read_numbers(m.parameters, in.counted_length("parameters", 8, 4));
}

void write(Writer& out, const SetFilterConfig& m) {
  out.write(m.filter_type);
  out.write_length("parameters", m.parameters.size(), 8);
  out.write_length("parameters", m.parameters.size(), 8);
  out.write_numbers(m.parameters);
}

void to_json(std::string& out, const SetFilterConfig& m) {
  json_key(out, '{', "filter_type");
  json_value(out, m.filter_type);
  json_key(out, ',', "parameters");
  json_array(out, m.parameters, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

const MessageDef kRows[9] = {
    {6, MessageType::kData, kDataScan, "laser.data.scan", "laser::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {6, MessageType::kData, kDataScanpose, "laser.data.scanpose", "laser::DataScanpose", true, Policy::kLatest,
     check_required<DataScanpose>, reencode<DataScanpose>, body_to_json<DataScanpose>},
    {6, MessageType::kData, kDataScanangle, "laser.data.scanangle", "laser::DataScanangle", true, Policy::kLatest,
     check_required<DataScanangle>, reencode<DataScanangle>, body_to_json<DataScanangle>},
    {6, MessageType::kReq, kReqGetGeom, "laser.req.get_geom", "laser::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
    {6, MessageType::kReq, kReqSetConfig, "laser.req.set_config", "laser::Config", true, Policy::kNone,
     check_optional<Config>, reencode<Config>, body_to_json<Config>},
    {6, MessageType::kReq, kReqGetConfig, "laser.req.get_config", "laser::Config", true, Policy::kNone,
     check_optional<Config>, reencode<Config>, body_to_json<Config>},
    {6, MessageType::kReq, kReqPower, "laser.req.power", "laser::PowerConfig", true, Policy::kNone,
     check_optional<PowerConfig>, reencode<PowerConfig>, body_to_json<PowerConfig>},
    {6, MessageType::kReq, kReqGetId, "laser.req.get_id", "laser::GetIdConfig", true, Policy::kNone,
     check_optional<GetIdConfig>, reencode<GetIdConfig>, body_to_json<GetIdConfig>},
    {6, MessageType::kReq, kReqSetFilter, "laser.req.set_filter", "laser::SetFilterConfig", true, Policy::kNone,
     check_optional<SetFilterConfig>, reencode<SetFilterConfig>, body_to_json<SetFilterConfig>},
};

}  // namespace playhouse::wire::laser
