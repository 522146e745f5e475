// Generated from interfaces/007_blobfinder.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/blobfinder.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::blobfinder {

void read(Reader& in, Blob& m) {
  in.read(m.id);
  in.read(m.color);
  in.read(m.area);
  in.read(m.x);
  in.read(m.y);
  in.read(m.left);
  in.read(m.right);
  in.read(m.top);
  in.read(m.bottom);
  in.read(m.range);
}

void write(Writer& out, const Blob& m) {
  out.write(m.id);
  out.write(m.color);
  out.write(m.area);
  out.write(m.x);
  out.write(m.y);
  out.write(m.left);
  out.write(m.right);
  out.write(m.top);
  out.write(m.bottom);
  out.write(m.range);
}

void to_json(std::string& out, const Blob& m) {
  json_key(out, '{', "id");
  json_value(out, m.id);
  json_key(out, ',', "color");
  json_value(out, m.color);
  json_key(out, ',', "area");
  json_value(out, m.area);
  json_key(out, ',', "x");
  json_value(out, m.x);
  json_key(out, ',', "y");
  json_value(out, m.y);
  json_key(out, ',', "left");
  json_value(out, m.left);
  json_key(out, ',', "right");
  json_value(out, m.right);
  json_key(out, ',', "top");
  json_value(out, m.top);
  json_key(out, ',', "bottom");
  json_value(out, m.bottom);
  json_key(out, ',', "range");
  json_value(out, m.range);
  out += '}';
}

void read(Reader& in, Data& m) {
  in.read(m.width);
  in.read(m.height);
  std::uint32_t blobs_count = 0;
  in.read(blobs_count);
  m.blobs.resize(in.dynamic_length("blobs", blobs_count, 40));
  for (auto& element : m.blobs) read(in, element);
}

void write(Writer& out, const Data& m) {
  out.write(m.width);
  out.write(m.height);
  out.write_length("blobs", m.blobs.size(), 838859);
  out.write_length("blobs", m.blobs.size(), 838859);
  for (const auto& element : m.blobs) write(out, element);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "width");
  json_value(out, m.width);
  json_key(out, ',', "height");
  json_value(out, m.height);
  json_key(out, ',', "blobs");
  json_array(out, m.blobs, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, ColorConfig& m) {
  in.read(m.channel);
  in.read(m.rmin);
  in.read(m.rmax);
  in.read(m.gmin);
  in.read(m.gmax);
  in.read(m.bmin);
  in.read(m.bmax);
}

void write(Writer& out, const ColorConfig& m) {
  out.write(m.channel);
  out.write(m.rmin);
  out.write(m.rmax);
  out.write(m.gmin);
  out.write(m.gmax);
  out.write(m.bmin);
  out.write(m.bmax);
}

void to_json(std::string& out, const ColorConfig& m) {
  json_key(out, '{', "channel");
  json_value(out, m.channel);
  json_key(out, ',', "rmin");
  json_value(out, m.rmin);
  json_key(out, ',', "rmax");
  json_value(out, m.rmax);
  json_key(out, ',', "gmin");
  json_value(out, m.gmin);
  json_key(out, ',', "gmax");
  json_value(out, m.gmax);
  json_key(out, ',', "bmin");
  json_value(out, m.bmin);
  json_key(out, ',', "bmax");
  json_value(out, m.bmax);
  out += '}';
}

void read(Reader& in, ImagerConfig& m) {
  in.read(m.brightness);
  in.read(m.contrast);
  in.read(m.colormode);
  in.read(m.autogain);
}

void write(Writer& out, const ImagerConfig& m) {
  out.write(m.brightness);
  out.write(m.contrast);
  out.write(m.colormode);
  out.write(m.autogain);
}

void to_json(std::string& out, const ImagerConfig& m) {
  json_key(out, '{', "brightness");
  json_value(out, m.brightness);
  json_key(out, ',', "contrast");
  json_value(out, m.contrast);
  json_key(out, ',', "colormode");
  json_value(out, m.colormode);
  json_key(out, ',', "autogain");
  json_value(out, m.autogain);
  out += '}';
}

const MessageDef kRows[4] = {
    {7, MessageType::kData, kDataBlobs, "blobfinder.data.blobs", "blobfinder::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {7, MessageType::kReq, kReqSetColor, "blobfinder.req.set_color", "blobfinder::ColorConfig", true, Policy::kNone,
     check_optional<ColorConfig>, reencode<ColorConfig>, body_to_json<ColorConfig>},
    {7, MessageType::kReq, kReqSetImagerParams, "blobfinder.req.set_imager_params", "blobfinder::ImagerConfig", true, Policy::kNone,
     check_optional<ImagerConfig>, reencode<ImagerConfig>, body_to_json<ImagerConfig>},
    {7, MessageType::kReq, kReqGetColor, "blobfinder.req.get_color", "blobfinder::ColorConfig", true, Policy::kNone,
     check_optional<ColorConfig>, reencode<ColorConfig>, body_to_json<ColorConfig>},
};

}  // namespace playhouse::wire::blobfinder
