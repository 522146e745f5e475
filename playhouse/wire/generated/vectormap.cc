// Generated from interfaces/063_vectormap.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/vectormap.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::vectormap {

void read(Reader& in, FeatureData& m) {
  std::uint32_t name_count = 0;
  in.read(name_count);
  in.read_bytes(m.name, in.dynamic_length("name", name_count, 1));
  std::uint32_t wkb_count = 0;
  in.read(wkb_count);
  in.read_bytes(m.wkb, in.dynamic_length("wkb", wkb_count, 1));
  std::uint32_t attrib_count = 0;
  in.read(attrib_count);
  in.read_bytes(m.attrib, in.dynamic_length("attrib", attrib_count, 1));
}

void write(Writer& out, const FeatureData& m) {
  out.write_length("name", m.name.size(), 33554392);
  out.write_length("name", m.name.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.name)));
  out.write_length("wkb", m.wkb.size(), 33554392);
  out.write_length("wkb", m.wkb.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.wkb)));
  out.write_length("attrib", m.attrib.size(), 33554392);
  out.write_length("attrib", m.attrib.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.attrib)));
}

void to_json(std::string& out, const FeatureData& m) {
  json_key(out, '{', "name");
  json_text(out, m.name);
  json_key(out, ',', "wkb");
  json_bytes(out, m.wkb);
  json_key(out, ',', "attrib");
  json_text(out, m.attrib);
  out += '}';
}

void read(Reader& in, LayerInfo& m) {
  std::uint32_t name_count = 0;
  in.read(name_count);
  in.read_bytes(m.name, in.dynamic_length("name", name_count, 1));
  read(in, m.extent);
}

void write(Writer& out, const LayerInfo& m) {
  out.write_length("name", m.name.size(), 33554392);
  out.write_length("name", m.name.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.name)));
  write(out, m.extent);
}

void to_json(std::string& out, const LayerInfo& m) {
  json_key(out, '{', "name");
  json_text(out, m.name);
  json_key(out, ',', "extent");
  to_json(out, m.extent);
  out += '}';
}

void read(Reader& in, LayerData& m) {
  std::uint32_t name_count = 0;
  in.read(name_count);
  in.read_bytes(m.name, in.dynamic_length("name", name_count, 1));
  std::uint32_t features_count = 0;
  in.read(features_count);
  m.features.resize(in.dynamic_length("features", features_count, 24));
  for (auto& element : m.features) read(in, element);
}

void write(Writer& out, const LayerData& m) {
  out.write_length("name", m.name.size(), 33554392);
  out.write_length("name", m.name.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.name)));
  out.write_length("features", m.features.size(), 1398099);
  out.write_length("features", m.features.size(), 1398099);
  for (const auto& element : m.features) write(out, element);
}

void to_json(std::string& out, const LayerData& m) {
  json_key(out, '{', "name");
  json_text(out, m.name);
  json_key(out, ',', "features");
  json_array(out, m.features, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, Info& m) {
  in.read(m.srid);
  std::uint32_t layers_count = 0;
  in.read(layers_count);
  m.layers.resize(in.dynamic_length("layers", layers_count, 40));
  for (auto& element : m.layers) read(in, element);
  read(in, m.extent);
}

void write(Writer& out, const Info& m) {
  out.write(m.srid);
  out.write_length("layers", m.layers.size(), 838859);
  out.write_length("layers", m.layers.size(), 838859);
  for (const auto& element : m.layers) write(out, element);
  write(out, m.extent);
}

void to_json(std::string& out, const Info& m) {
  json_key(out, '{', "srid");
  json_value(out, m.srid);
  json_key(out, ',', "layers");
  json_array(out, m.layers, [](std::string& to, const auto& e) { to_json(to, e); });
  json_key(out, ',', "extent");
  to_json(out, m.extent);
  out += '}';
}

const MessageDef kRows[3] = {
    {63, MessageType::kReq, kReqGetMapInfo, "vectormap.req.get_map_info", "vectormap::Info", true, Policy::kNone,
     check_optional<Info>, reencode<Info>, body_to_json<Info>},
    {63, MessageType::kReq, kReqGetLayerData, "vectormap.req.get_layer_data", "vectormap::LayerData", true, Policy::kNone,
     check_optional<LayerData>, reencode<LayerData>, body_to_json<LayerData>},
    {63, MessageType::kReq, kReqWriteLayer, "vectormap.req.write_layer", "vectormap::LayerData", true, Policy::kNone,
     check_optional<LayerData>, reencode<LayerData>, body_to_json<LayerData>},
};

}  // namespace playhouse::wire::vectormap
