// Generated from interfaces/040_camera.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/camera.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::camera {

void read(Reader& in, Data& m) {
  in.read(m.width);
  in.read(m.height);
  in.read(m.bpp);
  in.read(m.format);
  in.read(m.fdiv);
  in.read(m.compression);
  std::uint32_t image_count = 0;
  in.read(image_count);
  in.read_bytes(m.image, in.dynamic_length("image", image_count, 1));
}

void write(Writer& out, const Data& m) {
  out.write(m.width);
  out.write(m.height);
  out.write(m.bpp);
  out.write(m.format);
  out.write(m.fdiv);
  out.write(m.compression);
  out.write_length("image", m.image.size(), 33554392);
  out.write_length("image", m.image.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.image)));
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "width");
  json_value(out, m.width);
  json_key(out, ',', "height");
  json_value(out, m.height);
  json_key(out, ',', "bpp");
  json_value(out, m.bpp);
  json_key(out, ',', "format");
  json_value(out, m.format);
  json_key(out, ',', "fdiv");
  json_value(out, m.fdiv);
  json_key(out, ',', "compression");
  json_value(out, m.compression);
  json_key(out, ',', "image");
  json_bytes(out, m.image);
  out += '}';
}

void read(Reader& in, Source& m) {
  std::uint32_t norm_count = 0;
  in.read(norm_count);
  in.read_bytes(m.norm, in.dynamic_length("norm", norm_count, 1));
  in.read(m.source);
}

void write(Writer& out, const Source& m) {
  out.write_length("norm", m.norm.size(), 33554392);
  out.write_length("norm", m.norm.size(), 33554392);
  out.write_bytes(std::as_bytes(std::span(m.norm)));
  out.write(m.source);
}

void to_json(std::string& out, const Source& m) {
  json_key(out, '{', "norm");
  json_text(out, m.norm);
  json_key(out, ',', "source");
  json_value(out, m.source);
  out += '}';
}

const MessageDef kRows[4] = {
    {40, MessageType::kData, kDataState, "camera.data.state", "camera::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {40, MessageType::kReq, kReqGetSource, "camera.req.get_source", "camera::Source", true, Policy::kNone,
     check_optional<Source>, reencode<Source>, body_to_json<Source>},
    {40, MessageType::kReq, kReqSetSource, "camera.req.set_source", "camera::Source", true, Policy::kNone,
     check_optional<Source>, reencode<Source>, body_to_json<Source>},
    {40, MessageType::kReq, kReqGetImage, "camera.req.get_image", "camera::Data", true, Policy::kNone,
     check_optional<Data>, reencode<Data>, body_to_json<Data>},
};

}  // namespace playhouse::wire::camera
