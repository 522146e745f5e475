// Generated from interfaces/025_localize.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/localize.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::localize {

void read(Reader& in, Hypoth& m) {
  read(in, m.mean);
  for (auto& element : m.cov) in.read(element);
  in.read(m.alpha);
}

void write(Writer& out, const Hypoth& m) {
  write(out, m.mean);
  for (const auto& element : m.cov) out.write(element);
  out.write(m.alpha);
}

void to_json(std::string& out, const Hypoth& m) {
  json_key(out, '{', "mean");
  to_json(out, m.mean);
  json_key(out, ',', "cov");
  json_array(out, m.cov, [](std::string& to, const auto& e) { json_value(to, e); });
  json_key(out, ',', "alpha");
  json_value(out, m.alpha);
  out += '}';
}

void read(Reader& in, Data& m) {
  in.read(m.pending_count);
  in.read(m.pending_time);
  std::uint32_t hypoths_count = 0;
  in.read(hypoths_count);
  m.hypoths.resize(in.dynamic_length("hypoths", hypoths_count, 80));
  for (auto& element : m.hypoths) read(in, element);
}

void write(Writer& out, const Data& m) {
  out.write(m.pending_count);
  out.write(m.pending_time);
  out.write_length("hypoths", m.hypoths.size(), 419429);
  out.write_length("hypoths", m.hypoths.size(), 419429);
  for (const auto& element : m.hypoths) write(out, element);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "pending_count");
  json_value(out, m.pending_count);
  json_key(out, ',', "pending_time");
  json_value(out, m.pending_time);
  json_key(out, ',', "hypoths");
  json_array(out, m.hypoths, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

void read(Reader& in, SetPose& m) {
  read(in, m.mean);
  for (auto& element : m.cov) in.read(element);
}

void write(Writer& out, const SetPose& m) {
  write(out, m.mean);
  for (const auto& element : m.cov) out.write(element);
}

void to_json(std::string& out, const SetPose& m) {
  json_key(out, '{', "mean");
  to_json(out, m.mean);
  json_key(out, ',', "cov");
  json_array(out, m.cov, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, Particle& m) {
  read(in, m.pose);
  in.read(m.alpha);
}

void write(Writer& out, const Particle& m) {
  write(out, m.pose);
  out.write(m.alpha);
}

void to_json(std::string& out, const Particle& m) {
  json_key(out, '{', "pose");
  to_json(out, m.pose);
  json_key(out, ',', "alpha");
  json_value(out, m.alpha);
  out += '}';
}

void read(Reader& in, GetParticles& m) {
  read(in, m.mean);
  in.read(m.variance);
  std::uint32_t particles_count = 0;
  in.read(particles_count);
  m.particles.resize(in.dynamic_length("particles", particles_count, 32));
  for (auto& element : m.particles) read(in, element);
}

void write(Writer& out, const GetParticles& m) {
  write(out, m.mean);
  out.write(m.variance);
  out.write_length("particles", m.particles.size(), 1048574);
  out.write_length("particles", m.particles.size(), 1048574);
  for (const auto& element : m.particles) write(out, element);
}

void to_json(std::string& out, const GetParticles& m) {
  json_key(out, '{', "mean");
  to_json(out, m.mean);
  json_key(out, ',', "variance");
  json_value(out, m.variance);
  json_key(out, ',', "particles");
  json_array(out, m.particles, [](std::string& to, const auto& e) { to_json(to, e); });
  out += '}';
}

const MessageDef kRows[3] = {
    {25, MessageType::kData, kDataHypoths, "localize.data.hypoths", "localize::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {25, MessageType::kReq, kReqSetPose, "localize.req.set_pose", "localize::SetPose", true, Policy::kNone,
     check_optional<SetPose>, reencode<SetPose>, body_to_json<SetPose>},
    {25, MessageType::kReq, kReqGetParticles, "localize.req.get_particles", "localize::GetParticles", true, Policy::kNone,
     check_optional<GetParticles>, reencode<GetParticles>, body_to_json<GetParticles>},
};

}  // namespace playhouse::wire::localize
