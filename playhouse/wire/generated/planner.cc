// Generated from interfaces/044_planner.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/planner.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::planner {

void read(Reader& in, Data& m) {
  in.read(m.valid);
  in.read(m.done);
  read(in, m.pos);
  read(in, m.goal);
  read(in, m.waypoint);
  in.read(m.waypoint_idx);
  in.read(m.waypoints_count);
}

void write(Writer& out, const Data& m) {
  out.write(m.valid);
  out.write(m.done);
  write(out, m.pos);
  write(out, m.goal);
  write(out, m.waypoint);
  out.write(m.waypoint_idx);
  out.write(m.waypoints_count);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "valid");
  json_value(out, m.valid);
  json_key(out, ',', "done");
  json_value(out, m.done);
  json_key(out, ',', "pos");
  to_json(out, m.pos);
  json_key(out, ',', "goal");
  to_json(out, m.goal);
  json_key(out, ',', "waypoint");
  to_json(out, m.waypoint);
  json_key(out, ',', "waypoint_idx");
  json_value(out, m.waypoint_idx);
  json_key(out, ',', "waypoints_count");
  json_value(out, m.waypoints_count);
  out += '}';
}

void read(Reader& in, Cmd& m) {
  read(in, m.goal);
}

void write(Writer& out, const Cmd& m) {
  write(out, m.goal);
}

void to_json(std::string& out, const Cmd& m) {
  json_key(out, '{', "goal");
  to_json(out, m.goal);
  out += '}';
}

void read(Reader& in, WaypointsReq& m) {
  in.read(m.waypoints_distance);
  std::uint32_t waypoints_count = 0;
  in.read(waypoints_count);
  m.waypoints.resize(in.dynamic_length("waypoints", waypoints_count, 24));
  for (auto& element : m.waypoints) read(in, element);
}

void write(Writer& out, const WaypointsReq& m) {
  out.write(m.waypoints_distance);
  out.write_length("waypoints", m.waypoints.size(), 1398099);
  out.write_length("waypoints", m.waypoints.size(), 1398099);
  for (const auto& element : m.waypoints) write(out, element);
}

void to_json(std::string& out, const WaypointsReq& m) {
  json_key(out, '{', "waypoints_distance");
  json_value(out, m.waypoints_distance);
  json_key(out, ',', "waypoints");
  json_array(out, m.waypoints, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, EnableReq& m) {
  in.read(m.state);
}

void write(Writer& out, const EnableReq& m) {
  out.write(m.state);
}

void to_json(std::string& out, const EnableReq& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

const MessageDef kRows[5] = {
    {44, MessageType::kData, kDataState, "planner.data.state", "planner::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {44, MessageType::kCmd, kCmdGoal, "planner.cmd.goal", "planner::Cmd", true, Policy::kLatest,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
    {44, MessageType::kCmd, kCmdStart, "planner.cmd.start", "planner::Cmd", true, Policy::kLatest,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
    {44, MessageType::kReq, kReqGetWaypoints, "planner.req.get_waypoints", "planner::WaypointsReq", true, Policy::kNone,
     check_optional<WaypointsReq>, reencode<WaypointsReq>, body_to_json<WaypointsReq>},
    {44, MessageType::kReq, kReqEnable, "planner.req.enable", "planner::EnableReq", true, Policy::kNone,
     check_optional<EnableReq>, reencode<EnableReq>, body_to_json<EnableReq>},
};

}  // namespace playhouse::wire::planner
