// Generated from interfaces/053_actarray.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/actarray.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::actarray {

void read(Reader& in, Actuator& m) {
  in.read(m.position);
  in.read(m.speed);
  in.read(m.acceleration);
  in.read(m.current);
  in.read(m.state);
}

void write(Writer& out, const Actuator& m) {
  out.write(m.position);
  out.write(m.speed);
  out.write(m.acceleration);
  out.write(m.current);
  out.write(m.state);
}

void to_json(std::string& out, const Actuator& m) {
  json_key(out, '{', "position");
  json_value(out, m.position);
  json_key(out, ',', "speed");
  json_value(out, m.speed);
  json_key(out, ',', "acceleration");
  json_value(out, m.acceleration);
  json_key(out, ',', "current");
  json_value(out, m.current);
  json_key(out, ',', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, Data& m) {
  std::uint32_t actuators_count = 0;
  in.read(actuators_count);
  m.actuators.resize(in.dynamic_length("actuators", actuators_count, 20));
  for (auto& element : m.actuators) read(in, element);
  in.read(m.motor_state);
}

void write(Writer& out, const Data& m) {
  out.write_length("actuators", m.actuators.size(), 1677719);
  out.write_length("actuators", m.actuators.size(), 1677719);
  for (const auto& element : m.actuators) write(out, element);
  out.write(m.motor_state);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "actuators");
  json_array(out, m.actuators, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "motor_state");
  json_value(out, m.motor_state);
  out += '}';
}

void read(Reader& in, Actuatorgeom& m) {
  in.read(m.type);
  in.read(m.length);
  read(in, m.orientation);
  read(in, m.axis);
  in.read(m.min);
  in.read(m.centre);
  in.read(m.max);
  in.read(m.home);
  in.read(m.config_speed);
  in.read(m.hasbrakes);
}

void write(Writer& out, const Actuatorgeom& m) {
  out.write(m.type);
  out.write(m.length);
  write(out, m.orientation);
  write(out, m.axis);
  out.write(m.min);
  out.write(m.centre);
  out.write(m.max);
  out.write(m.home);
  out.write(m.config_speed);
  out.write(m.hasbrakes);
}

void to_json(std::string& out, const Actuatorgeom& m) {
  json_key(out, '{', "type");
  json_value(out, m.type);
  json_key(out, ',', "length");
  json_value(out, m.length);
  json_key(out, ',', "orientation");
  to_json(out, m.orientation);
  json_key(out, ',', "axis");
  to_json(out, m.axis);
  json_key(out, ',', "min");
  json_value(out, m.min);
  json_key(out, ',', "centre");
  json_value(out, m.centre);
  json_key(out, ',', "max");
  json_value(out, m.max);
  json_key(out, ',', "home");
  json_value(out, m.home);
  json_key(out, ',', "config_speed");
  json_value(out, m.config_speed);
  json_key(out, ',', "hasbrakes");
  json_value(out, m.hasbrakes);
  out += '}';
}

void read(Reader& in, Geom& m) {
  std::uint32_t actuators_count = 0;
  in.read(actuators_count);
  m.actuators.resize(in.dynamic_length("actuators", actuators_count, 80));
  for (auto& element : m.actuators) read(in, element);
  read(in, m.base_pos);
  read(in, m.base_orientation);
}

void write(Writer& out, const Geom& m) {
  out.write_length("actuators", m.actuators.size(), 419429);
  out.write_length("actuators", m.actuators.size(), 419429);
  for (const auto& element : m.actuators) write(out, element);
  write(out, m.base_pos);
  write(out, m.base_orientation);
}

void to_json(std::string& out, const Geom& m) {
  json_key(out, '{', "actuators");
  json_array(out, m.actuators, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "base_pos");
  to_json(out, m.base_pos);
  json_key(out, ',', "base_orientation");
  to_json(out, m.base_orientation);
  out += '}';
}

void read(Reader& in, PositionCmd& m) {
  in.read(m.joint);
  in.read(m.position);
}

void write(Writer& out, const PositionCmd& m) {
  out.write(m.joint);
  out.write(m.position);
}

void to_json(std::string& out, const PositionCmd& m) {
  json_key(out, '{', "joint");
  json_value(out, m.joint);
  json_key(out, ',', "position");
  json_value(out, m.position);
  out += '}';
}

void read(Reader& in, MultiPositionCmd& m) {
  std::uint32_t positions_count = 0;
  in.read(positions_count);
  in.read_numbers(m.positions, in.dynamic_length("positions", positions_count, 4));
}

void write(Writer& out, const MultiPositionCmd& m) {
  out.write_length("positions", m.positions.size(), 8388598);
  out.write_length("positions", m.positions.size(), 8388598);
  out.write_numbers(m.positions);
}

void to_json(std::string& out, const MultiPositionCmd& m) {
  json_key(out, '{', "positions");
  json_array(out, m.positions, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, SpeedCmd& m) {
  in.read(m.joint);
  in.read(m.speed);
}

void write(Writer& out, const SpeedCmd& m) {
  out.write(m.joint);
  out.write(m.speed);
}

void to_json(std::string& out, const SpeedCmd& m) {
  json_key(out, '{', "joint");
  json_value(out, m.joint);
  json_key(out, ',', "speed");
  json_value(out, m.speed);
  out += '}';
}

void read(Reader& in, MultiSpeedCmd& m) {
  std::uint32_t speeds_count = 0;
  in.read(speeds_count);
  in.read_numbers(m.speeds, in.dynamic_length("speeds", speeds_count, 4));
}

void write(Writer& out, const MultiSpeedCmd& m) {
  out.write_length("speeds", m.speeds.size(), 8388598);
  out.write_length("speeds", m.speeds.size(), 8388598);
  out.write_numbers(m.speeds);
}

void to_json(std::string& out, const MultiSpeedCmd& m) {
  json_key(out, '{', "speeds");
  json_array(out, m.speeds, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, HomeCmd& m) {
  in.read(m.joint);
}

void write(Writer& out, const HomeCmd& m) {
  out.write(m.joint);
}

void to_json(std::string& out, const HomeCmd& m) {
  json_key(out, '{', "joint");
  json_value(out, m.joint);
  out += '}';
}

void read(Reader& in, CurrentCmd& m) {
  in.read(m.joint);
  in.read(m.current);
}

void write(Writer& out, const CurrentCmd& m) {
  out.write(m.joint);
  out.write(m.current);
}

void to_json(std::string& out, const CurrentCmd& m) {
  json_key(out, '{', "joint");
  json_value(out, m.joint);
  json_key(out, ',', "current");
  json_value(out, m.current);
  out += '}';
}

void read(Reader& in, MultiCurrentCmd& m) {
  std::uint32_t currents_count = 0;
  in.read(currents_count);
  in.read_numbers(m.currents, in.dynamic_length("currents", currents_count, 4));
}

void write(Writer& out, const MultiCurrentCmd& m) {
  out.write_length("currents", m.currents.size(), 8388598);
  out.write_length("currents", m.currents.size(), 8388598);
  out.write_numbers(m.currents);
}

void to_json(std::string& out, const MultiCurrentCmd& m) {
  json_key(out, '{', "currents");
  json_array(out, m.currents, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, PowerConfig& m) {
  in.read(m.value);
}

void write(Writer& out, const PowerConfig& m) {
  out.write(m.value);
}

void to_json(std::string& out, const PowerConfig& m) {
  json_key(out, '{', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, BrakesConfig& m) {
  in.read(m.value);
}

void write(Writer& out, const BrakesConfig& m) {
  out.write(m.value);
}

void to_json(std::string& out, const BrakesConfig& m) {
  json_key(out, '{', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, SpeedConfig& m) {
  in.read(m.joint);
  in.read(m.speed);
}

void write(Writer& out, const SpeedConfig& m) {
  out.write(m.joint);
  out.write(m.speed);
}

void to_json(std::string& out, const SpeedConfig& m) {
  json_key(out, '{', "joint");
  json_value(out, m.joint);
  json_key(out, ',', "speed");
  json_value(out, m.speed);
  out += '}';
}

void read(Reader& in, AccelConfig& m) {
  in.read(m.joint);
  in.read(m.accel);
}

void write(Writer& out, const AccelConfig& m) {
  out.write(m.joint);
  out.write(m.accel);
}

void to_json(std::string& out, const AccelConfig& m) {
  json_key(out, '{', "joint");
  json_value(out, m.joint);
  json_key(out, ',', "accel");
  json_value(out, m.accel);
  out += '}';
}

const MessageDef kRows[13] = {
    {53, MessageType::kData, kDataState, "actarray.data.state", "actarray::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {53, MessageType::kCmd, kCmdPos, "actarray.cmd.pos", "actarray::PositionCmd", true, Policy::kQueue,
     check_required<PositionCmd>, reencode<PositionCmd>, body_to_json<PositionCmd>},
    {53, MessageType::kCmd, kCmdMultiPos, "actarray.cmd.multi_pos", "actarray::MultiPositionCmd", true, Policy::kLatest,
     check_required<MultiPositionCmd>, reencode<MultiPositionCmd>, body_to_json<MultiPositionCmd>},
    {53, MessageType::kCmd, kCmdSpeed, "actarray.cmd.speed", "actarray::SpeedCmd", true, Policy::kQueue,
     check_required<SpeedCmd>, reencode<SpeedCmd>, body_to_json<SpeedCmd>},
    {53, MessageType::kCmd, kCmdMultiSpeed, "actarray.cmd.multi_speed", "actarray::MultiSpeedCmd", true, Policy::kLatest,
     check_required<MultiSpeedCmd>, reencode<MultiSpeedCmd>, body_to_json<MultiSpeedCmd>},
    {53, MessageType::kCmd, kCmdHome, "actarray.cmd.home", "actarray::HomeCmd", true, Policy::kQueue,
     check_required<HomeCmd>, reencode<HomeCmd>, body_to_json<HomeCmd>},
    {53, MessageType::kCmd, kCmdCurrent, "actarray.cmd.current", "actarray::CurrentCmd", true, Policy::kQueue,
     check_required<CurrentCmd>, reencode<CurrentCmd>, body_to_json<CurrentCmd>},
    {53, MessageType::kCmd, kCmdMultiCurrent, "actarray.cmd.multi_current", "actarray::MultiCurrentCmd", true, Policy::kLatest,
     check_required<MultiCurrentCmd>, reencode<MultiCurrentCmd>, body_to_json<MultiCurrentCmd>},
    {53, MessageType::kReq, kReqPower, "actarray.req.power", "actarray::PowerConfig", true, Policy::kNone,
     check_optional<PowerConfig>, reencode<PowerConfig>, body_to_json<PowerConfig>},
    {53, MessageType::kReq, kReqBrakes, "actarray.req.brakes", "actarray::BrakesConfig", true, Policy::kNone,
     check_optional<BrakesConfig>, reencode<BrakesConfig>, body_to_json<BrakesConfig>},
    {53, MessageType::kReq, kReqGetGeom, "actarray.req.get_geom", "actarray::Geom", true, Policy::kNone,
     check_optional<Geom>, reencode<Geom>, body_to_json<Geom>},
    {53, MessageType::kReq, kReqSpeed, "actarray.req.speed", "actarray::SpeedConfig", true, Policy::kNone,
     check_optional<SpeedConfig>, reencode<SpeedConfig>, body_to_json<SpeedConfig>},
    {53, MessageType::kReq, kReqAccel, "actarray.req.accel", "actarray::AccelConfig", true, Policy::kNone,
     check_optional<AccelConfig>, reencode<AccelConfig>, body_to_json<AccelConfig>},
};

}  // namespace playhouse::wire::actarray
