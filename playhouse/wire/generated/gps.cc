// Generated from interfaces/013_gps.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/gps.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::gps {

void read(Reader& in, Data& m) {
  in.read(m.time_sec);
  in.read(m.time_usec);
  in.read(m.latitude);
  in.read(m.longitude);
  in.read(m.altitude);
  in.read(m.speed);
  in.read(m.course);
  in.read(m.utm_e);
  in.read(m.utm_n);
  in.read(m.quality);
  in.read(m.num_sats);
  in.read(m.hdop);
  in.read(m.vdop);
  in.read(m.err_horz);
  in.read(m.err_vert);
}

void write(Writer& out, const Data& m) {
  out.write(m.time_sec);
  out.write(m.time_usec);
  out.write(m.latitude);
  out.write(m.longitude);
  out.write(m.altitude);
  out.write(m.speed);
  out.write(m.course);
  out.write(m.utm_e);
  out.write(m.utm_n);
  out.write(m.quality);
  out.write(m.num_sats);
  out.write(m.hdop);
  out.write(m.vdop);
  out.write(m.err_horz);
  out.write(m.err_vert);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "time_sec");
  json_value(out, m.time_sec);
  json_key(out, ',', "time_usec");
  json_value(out, m.time_usec);
  json_key(out, ',', "latitude");
  json_value(out, m.latitude);
  json_key(out, ',', "longitude");
  json_value(out, m.longitude);
  json_key(out, ',', "altitude");
  json_value(out, m.altitude);
  json_key(out, ',', "speed");
  json_value(out, m.speed);
  json_key(out, ',', "course");
  json_value(out, m.course);
  json_key(out, ',', "utm_e");
  json_value(out, m.utm_e);
  json_key(out, ',', "utm_n");
  json_value(out, m.utm_n);
  json_key(out, ',', "quality");
  json_value(out, m.quality);
  json_key(out, ',', "num_sats");
  json_value(out, m.num_sats);
  json_key(out, ',', "hdop");
  json_value(out, m.hdop);
  json_key(out, ',', "vdop");
  json_value(out, m.vdop);
  json_key(out, ',', "err_horz");
  json_value(out, m.err_horz);
  json_key(out, ',', "err_vert");
  json_value(out, m.err_vert);
  out += '}';
}

const MessageDef kRows[1] = {
    {13, MessageType::kData, kDataState, "gps.data.state", "gps::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
};

}  // namespace playhouse::wire::gps
