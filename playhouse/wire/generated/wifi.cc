// Generated from interfaces/023_wifi.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/wifi.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::wifi {

void read(Reader& in, Link& m) {
  std::uint32_t mac_count = 0;
  in.read(mac_count);
  in.read_bytes(m.mac, in.counted_length("mac", 32, 1));
  std::uint32_t ip_count = 0;
  in.read(ip_count);
  in.read_bytes(m.ip, in.counted_length("ip", 32, 1));
  std::uint32_t essid_count = 0;
  in.read(essid_count);
  in.read_bytes(m.essid, in.counted_length("essid", 32, 1));
  in.read(m.mode);
  in.read(m.freq);
  in.read(m.encrypt);
  in.read(m.qual);
  in.read(m.level);
  in.read(m.noise);
}

void write(Writer& out, const Link& m) {
  out.write_length("mac", m.mac.size(), 32);
  out.write_length("mac", m.mac.size(), 32);
  out.write_bytes(std::as_bytes(std::span(m.mac)));
  out.write_length("ip", m.ip.size(), 32);
  out.write_length("ip", m.ip.size(), 32);
  out.write_bytes(std::as_bytes(std::span(m.ip)));
  out.write_length("essid", m.essid.size(), 32);
  out.write_length("essid", m.essid.size(), 32);
  out.write_bytes(std::as_bytes(std::span(m.essid)));
  out.write(m.mode);
  out.write(m.freq);
  out.write(m.encrypt);
  out.write(m.qual);
  out.write(m.level);
  out.write(m.noise);
}

void to_json(std::string& out, const Link& m) {
  json_key(out, '{', "mac");
  json_bytes(out, m.mac);
  json_key(out, ',', "ip");
  json_bytes(out, m.ip);
  json_key(out, ',', "essid");
  json_bytes(out, m.essid);
  json_key(out, ',', "mode");
  json_value(out, m.mode);
  json_key(out, ',', "freq");
  json_value(out, m.freq);
  json_key(out, ',', "encrypt");
  json_value(out, m.encrypt);
  json_key(out, ',', "qual");
  json_value(out, m.qual);
  json_key(out, ',', "level");
  json_value(out, m.level);
  json_key(out, ',', "noise");
  json_value(out, m.noise);
  out += '}';
}

void read(Reader& in, Data& m) {
  std::uint32_t links_count = 0;
  in.read(links_count);
  m.links.resize(in.dynamic_length("links", links_count, 48));
  for (auto& element : m.links) read(in, element);
  in.read(m.throughput);
  in.read(m.bitrate);
  in.read(m.mode);
  in.read(m.qual_type);
  in.read(m.maxqual);
  in.read(m.maxlevel);
  in.read(m.maxnoise);
  in.read_bytes(m.ap, 32);
}

void write(Writer& out, const Data& m) {
  out.write_length("links", m.links.size(), 699049);
  out.write_length("links", m.links.size(), 699049);
  for (const auto& element : m.links) write(out, element);
  out.write(m.throughput);
  out.write(m.bitrate);
  out.write(m.mode);
  out.write(m.qual_type);
  out.write(m.maxqual);
  out.write(m.maxlevel);
  out.write(m.maxnoise);
  out.write_fixed_text("ap", m.ap, 32);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "links");
  json_array(out, m.links, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "throughput");
  json_value(out, m.throughput);
  json_key(out, ',', "bitrate");
  json_value(out, m.bitrate);
  json_key(out, ',', "mode");
  json_value(out, m.mode);
  json_key(out, ',', "qual_type");
  json_value(out, m.qual_type);
  json_key(out, ',', "maxqual");
  json_value(out, m.maxqual);
  json_key(out, ',', "maxlevel");
  json_value(out, m.maxlevel);
  json_key(out, ',', "maxnoise");
  json_value(out, m.maxnoise);
  json_key(out, ',', "ap");
  json_text(out, m.ap);
  out += '}';
}

void read(Reader& in, MacReq& m) {
  std::uint32_t mac_count = 0;
  in.read(mac_count);
  in.read_bytes(m.mac, in.counted_length("mac", 32, 1));
}

void write(Writer& out, const MacReq& m) {
  out.write_length("mac", m.mac.size(), 32);
  out.write_length("mac", m.mac.size(), 32);
  out.write_bytes(std::as_bytes(std::span(m.mac)));
}

void to_json(std::string& out, const MacReq& m) {
  json_key(out, '{', "mac");
  json_bytes(out, m.mac);
  out += '}';
}

void read(Reader& in, IwspyAddrReq& m) {
  in.read_bytes(m.address, 32);
}

void write(Writer& out, const IwspyAddrReq& m) {
  out.write_fixed_text("address", m.address, 32);
}

void to_json(std::string& out, const IwspyAddrReq& m) {
  json_key(out, '{', "address");
  json_text(out, m.address);
  out += '}';
}

const MessageDef kRows[5] = {
    {23, MessageType::kData, kDataState, "wifi.data.state", "wifi::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {23, MessageType::kReq, kReqMac, "wifi.req.mac", "wifi::MacReq", true, Policy::kNone,
     check_optional<MacReq>, reencode<MacReq>, body_to_json<MacReq>},
    {23, MessageType::kReq, kReqIwspyAdd, "wifi.req.iwspy_add", "wifi::IwspyAddrReq", true, Policy::kNone,
     check_optional<IwspyAddrReq>, reencode<IwspyAddrReq>, body_to_json<IwspyAddrReq>},
    {23, MessageType::kReq, kReqIwspyDel, "wifi.req.iwspy_del", "wifi::IwspyAddrReq", true, Policy::kNone,
     check_optional<IwspyAddrReq>, reencode<IwspyAddrReq>, body_to_json<IwspyAddrReq>},
    {23, MessageType::kReq, kReqIwspyPing, "wifi.req.iwspy_ping", "wifi::IwspyAddrReq", true, Policy::kNone,
     check_optional<IwspyAddrReq>, reencode<IwspyAddrReq>, body_to_json<IwspyAddrReq>},
};

}  // namespace playhouse::wire::wifi
