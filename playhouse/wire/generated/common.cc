// Generated from interfaces/000_common.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/common.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire {

void read(Reader& in, Devaddr& m) {
  in.read(m.host);
  in.read(m.robot);
  in.read(m.interf);
  in.read(m.index);
}

void write(Writer& out, const Devaddr& m) {
  out.write(m.host);
  out.write(m.robot);
  out.write(m.interf);
  out.write(m.index);
}

void to_json(std::string& out, const Devaddr& m) {
  json_key(out, '{', "host");
  json_value(out, m.host);
  json_key(out, ',', "robot");
  json_value(out, m.robot);
  json_key(out, ',', "interf");
  json_value(out, m.interf);
  json_key(out, ',', "index");
  json_value(out, m.index);
  out += '}';
}

void read(Reader& in, Point2d& m) {
  in.read(m.px);
  in.read(m.py);
}

void write(Writer& out, const Point2d& m) {
  out.write(m.px);
  out.write(m.py);
}

void to_json(std::string& out, const Point2d& m) {
  json_key(out, '{', "px");
  json_value(out, m.px);
  json_key(out, ',', "py");
  json_value(out, m.py);
  out += '}';
}

void read(Reader& in, Point3d& m) {
  in.read(m.px);
  in.read(m.py);
  in.read(m.pz);
}

void write(Writer& out, const Point3d& m) {
  out.write(m.px);
  out.write(m.py);
  out.write(m.pz);
}

void to_json(std::string& out, const Point3d& m) {
  json_key(out, '{', "px");
  json_value(out, m.px);
  json_key(out, ',', "py");
  json_value(out, m.py);
  json_key(out, ',', "pz");
  json_value(out, m.pz);
  out += '}';
}

void read(Reader& in, Orientation3d& m) {
  in.read(m.proll);
  in.read(m.ppitch);
  in.read(m.pyaw);
}

void write(Writer& out, const Orientation3d& m) {
  out.write(m.proll);
  out.write(m.ppitch);
  out.write(m.pyaw);
}

void to_json(std::string& out, const Orientation3d& m) {
  json_key(out, '{', "proll");
  json_value(out, m.proll);
  json_key(out, ',', "ppitch");
  json_value(out, m.ppitch);
  json_key(out, ',', "pyaw");
  json_value(out, m.pyaw);
  out += '}';
}

void read(Reader& in, Pose2d& m) {
  in.read(m.px);
  in.read(m.py);
  in.read(m.pa);
}

void write(Writer& out, const Pose2d& m) {
  out.write(m.px);
  out.write(m.py);
  out.write(m.pa);
}

void to_json(std::string& out, const Pose2d& m) {
  json_key(out, '{', "px");
  json_value(out, m.px);
  json_key(out, ',', "py");
  json_value(out, m.py);
  json_key(out, ',', "pa");
  json_value(out, m.pa);
  out += '}';
}

void read(Reader& in, Pose3d& m) {
  in.read(m.px);
  in.read(m.py);
  in.read(m.pz);
  in.read(m.proll);
  in.read(m.ppitch);
  in.read(m.pyaw);
}

void write(Writer& out, const Pose3d& m) {
  out.write(m.px);
  out.write(m.py);
  out.write(m.pz);
  out.write(m.proll);
  out.write(m.ppitch);
  out.write(m.pyaw);
}

void to_json(std::string& out, const Pose3d& m) {
  json_key(out, '{', "px");
  json_value(out, m.px);
  json_key(out, ',', "py");
  json_value(out, m.py);
  json_key(out, ',', "pz");
  json_value(out, m.pz);
  json_key(out, ',', "proll");
  json_value(out, m.proll);
  json_key(out, ',', "ppitch");
  json_value(out, m.ppitch);
  json_key(out, ',', "pyaw");
  json_value(out, m.pyaw);
  out += '}';
}

void read(Reader& in, Bbox2d& m) {
  in.read(m.sw);
  in.read(m.sl);
}

void write(Writer& out, const Bbox2d& m) {
  out.write(m.sw);
  out.write(m.sl);
}

void to_json(std::string& out, const Bbox2d& m) {
  json_key(out, '{', "sw");
  json_value(out, m.sw);
  json_key(out, ',', "sl");
  json_value(out, m.sl);
  out += '}';
}

void read(Reader& in, Bbox3d& m) {
  in.read(m.sw);
  in.read(m.sl);
  in.read(m.sh);
}

void write(Writer& out, const Bbox3d& m) {
  out.write(m.sw);
  out.write(m.sl);
  out.write(m.sh);
}

void to_json(std::string& out, const Bbox3d& m) {
  json_key(out, '{', "sw");
  json_value(out, m.sw);
  json_key(out, ',', "sl");
  json_value(out, m.sl);
  json_key(out, ',', "sh");
  json_value(out, m.sh);
  out += '}';
}

void read(Reader& in, BlackboardEntry& m) {
  std::uint32_t key_count = 0;
  in.read(key_count);
  in.read_bytes(m.key, in.dynamic_length("key", key_count, 1));
  std::uint32_t group_count = 0;
  in.read(group_count);
  in.read_bytes(m.group, in.dynamic_length("group", group_count, 1));
  in.read(m.type);
  in.read(m.subtype);
  std::uint32_t data_count = 0;
  in.read(data_count);
  in.read_bytes(m.data, in.dynamic_length("data", data_count, 1));
  in.read(m.timestamp_sec);
  in.read(m.timestamp_usec);
}

void write(Writer& out, const BlackboardEntry& m) {
  out.write_length("key", m.key.size(), 33554392);
  out.write_length("key", m.key.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.key)));
  out.write_length("group", m.group.size(), 33554392);
  out.write_length("group", m.group.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.group)));
  out.write(m.type);
  out.write(m.subtype);
  out.write_length("data", m.data.size(), 33554392);
  out.write_length("data", m.data.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.data)));
  out.write(m.timestamp_sec);
  out.write(m.timestamp_usec);
}

void to_json(std::string& out, const BlackboardEntry& m) {
  json_key(out, '{', "key");
  json_text(out, m.key);
  json_key(out, ',', "group");
  json_text(out, m.group);
  json_key(out, ',', "type");
  json_value(out, m.type);
  json_key(out, ',', "subtype");
  json_value(out, m.subtype);
  json_key(out, ',', "data");
  json_bytes(out, m.data);
  json_key(out, ',', "timestamp_sec");
  json_value(out, m.timestamp_sec);
  json_key(out, ',', "timestamp_usec");
  json_value(out, m.timestamp_usec);
  out += '}';
}

void read(Reader& in, Segment& m) {
  in.read(m.x0);
  in.read(m.y0);
  in.read(m.x1);
  in.read(m.y1);
}

void write(Writer& out, const Segment& m) {
  out.write(m.x0);
  out.write(m.y0);
  out.write(m.x1);
  out.write(m.y1);
}

void to_json(std::string& out, const Segment& m) {
  json_key(out, '{', "x0");
  json_value(out, m.x0);
  json_key(out, ',', "y0");
  json_value(out, m.y0);
  json_key(out, ',', "x1");
  json_value(out, m.x1);
  json_key(out, ',', "y1");
  json_value(out, m.y1);
  out += '}';
}

void read(Reader& in, Extent2d& m) {
  in.read(m.x0);
  in.read(m.y0);
  in.read(m.x1);
  in.read(m.y1);
}

void write(Writer& out, const Extent2d& m) {
  out.write(m.x0);
  out.write(m.y0);
  out.write(m.x1);
  out.write(m.y1);
}

void to_json(std::string& out, const Extent2d& m) {
  json_key(out, '{', "x0");
  json_value(out, m.x0);
  json_key(out, ',', "y0");
  json_value(out, m.y0);
  json_key(out, ',', "x1");
  json_value(out, m.x1);
  json_key(out, ',', "y1");
  json_value(out, m.y1);
  out += '}';
}

void read(Reader& in, Color& m) {
  in.read(m.alpha);
  in.read(m.red);
  in.read(m.green);
  in.read(m.blue);
}

void write(Writer& out, const Color& m) {
  out.write(m.alpha);
  out.write(m.red);
  out.write(m.green);
  out.write(m.blue);
}

void to_json(std::string& out, const Color& m) {
  json_key(out, '{', "alpha");
  json_value(out, m.alpha);
  json_key(out, ',', "red");
  json_value(out, m.red);
  json_key(out, ',', "green");
  json_value(out, m.green);
  json_key(out, ',', "blue");
  json_value(out, m.blue);
  out += '}';
}

void read(Reader& in, Bool& m) {
  in.read(m.state);
}

void write(Writer& out, const Bool& m) {
  out.write(m.state);
}

void to_json(std::string& out, const Bool& m) {
  json_key(out, '{', "state");
  json_value(out, m.state);
  out += '}';
}

void read(Reader& in, Uint32& m) {
  in.read(m.value);
}

void write(Writer& out, const Uint32& m) {
  out.write(m.value);
}

void to_json(std::string& out, const Uint32& m) {
  json_key(out, '{', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, CapabilitiesReq& m) {
  in.read(m.type);
  in.read(m.subtype);
}

void write(Writer& out, const CapabilitiesReq& m) {
  out.write(m.type);
  out.write(m.subtype);
}

void to_json(std::string& out, const CapabilitiesReq& m) {
  json_key(out, '{', "type");
  json_value(out, m.type);
  json_key(out, ',', "subtype");
  json_value(out, m.subtype);
  out += '}';
}

void read(Reader& in, BoolpropReq& m) {
  std::uint32_t key_count = 0;
  in.read(key_count);
  in.read_bytes(m.key, in.dynamic_length("key", key_count, 1));
  in.read(m.value);
}

void write(Writer& out, const BoolpropReq& m) {
  out.write_length("key", m.key.size(), 33554392);
  out.write_length("key", m.key.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.key)));
  out.write(m.value);
}

void to_json(std::string& out, const BoolpropReq& m) {
  json_key(out, '{', "key");
  json_text(out, m.key);
  json_key(out, ',', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, IntpropReq& m) {
  std::uint32_t key_count = 0;
  in.read(key_count);
  in.read_bytes(m.key, in.dynamic_length("key", key_count, 1));
  in.read(m.value);
}

void write(Writer& out, const IntpropReq& m) {
  out.write_length("key", m.key.size(), 33554392);
  out.write_length("key", m.key.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.key)));
  out.write(m.value);
}

void to_json(std::string& out, const IntpropReq& m) {
  json_key(out, '{', "key");
  json_text(out, m.key);
  json_key(out, ',', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, DblpropReq& m) {
  std::uint32_t key_count = 0;
  in.read(key_count);
  in.read_bytes(m.key, in.dynamic_length("key", key_count, 1));
  in.read(m.value);
}

void write(Writer& out, const DblpropReq& m) {
  out.write_length("key", m.key.size(), 33554392);
  out.write_length("key", m.key.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.key)));
  out.write(m.value);
}

void to_json(std::string& out, const DblpropReq& m) {
  json_key(out, '{', "key");
  json_text(out, m.key);
  json_key(out, ',', "value");
  json_value(out, m.value);
  out += '}';
}

void read(Reader& in, StrpropReq& m) {
  std::uint32_t key_count = 0;
  in.read(key_count);
  in.read_bytes(m.key, in.dynamic_length("key", key_count, 1));
  std::uint32_t value_count = 0;
  in.read(value_count);
  in.read_bytes(m.value, in.dynamic_length("value", value_count, 1));
}

void write(Writer& out, const StrpropReq& m) {
  out.write_length("key", m.key.size(), 33554392);
  out.write_length("key", m.key.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.key)));
  out.write_length("value", m.value.size(), 33554392);
  out.write_length("value", m.value.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.value)));
}

void to_json(std::string& out, const StrpropReq& m) {
  json_key(out, '{', "key");
  json_text(out, m.key);
  json_key(out, ',', "value");
  json_text(out, m.value);
  out += '}';
}

const MessageDef kRows[9] = {
    {0, MessageType::kReq, kReqSetBoolprop, "universal.req.set_boolprop", "BoolpropReq", true, Policy::kNone,
     check_optional<BoolpropReq>, reencode<BoolpropReq>, body_to_json<BoolpropReq>},
    {0, MessageType::kReq, kReqGetBoolprop, "universal.req.get_boolprop", "BoolpropReq", true, Policy::kNone,
     check_optional<BoolpropReq>, reencode<BoolpropReq>, body_to_json<BoolpropReq>},
    {0, MessageType::kReq, kReqSetStrprop, "universal.req.set_strprop", "StrpropReq", true, Policy::kNone,
     check_optional<StrpropReq>, reencode<StrpropReq>, body_to_json<StrpropReq>},
    {0, MessageType::kReq, kReqGetStrprop, "universal.req.get_strprop", "StrpropReq", true, Policy::kNone,
     check_optional<StrpropReq>, reencode<StrpropReq>, body_to_json<StrpropReq>},
    {0, MessageType::kReq, kReqSetDblprop, "universal.req.set_dblprop", "DblpropReq", true, Policy::kNone,
     check_optional<DblpropReq>, reencode<DblpropReq>, body_to_json<DblpropReq>},
    {0, MessageType::kReq, kReqGetDblprop, "universal.req.get_dblprop", "DblpropReq", true, Policy::kNone,
     check_optional<DblpropReq>, reencode<DblpropReq>, body_to_json<DblpropReq>},
    {0, MessageType::kReq, kReqSetIntprop, "universal.req.set_intprop", "IntpropReq", true, Policy::kNone,
     check_optional<IntpropReq>, reencode<IntpropReq>, body_to_json<IntpropReq>},
    {0, MessageType::kReq, kReqGetIntprop, "universal.req.get_intprop", "IntpropReq", true, Policy::kNone,
     check_optional<IntpropReq>, reencode<IntpropReq>, body_to_json<IntpropReq>},
    {0, MessageType::kReq, kReqCapabilities, "universal.req.capabilities", "CapabilitiesReq", true, Policy::kNone,
     check_optional<CapabilitiesReq>, reencode<CapabilitiesReq>, body_to_json<CapabilitiesReq>},
};

}  // namespace playhouse::wire
