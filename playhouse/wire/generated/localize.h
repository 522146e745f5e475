// Generated from interfaces/025_localize.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::localize {

inline constexpr std::uint16_t kCode = 25;

// Subtypes of messages.
inline constexpr std::uint8_t kDataHypoths = 1;
inline constexpr std::uint8_t kReqSetPose = 1;
inline constexpr std::uint8_t kReqGetParticles = 2;

struct Hypoth {
  /// [frame X_RS, m, m, rad]
  Pose2d mean{};
  /// [m^2, m^2, rad^2, xy, ya, xa]
  std::array<double, 6> cov{};
  /// [1]
  double alpha = 0;

  friend bool operator==(const Hypoth&, const Hypoth&) = default;
};

struct Data {
  std::uint32_t pending_count = 0;
  /// [s]
  double pending_time = 0;
  std::vector<Hypoth> hypoths{};

  friend bool operator==(const Data&, const Data&) = default;
};

struct SetPose {
  /// [frame X_RS, m, m, rad]
  Pose2d mean{};
  /// [m^2, m^2, rad^2, xy, ya, xa]
  std::array<double, 6> cov{};

  friend bool operator==(const SetPose&, const SetPose&) = default;
};

struct Particle {
  /// [frame X_RS, m, m, rad]
  Pose2d pose{};
  /// [1]
  double alpha = 0;

  friend bool operator==(const Particle&, const Particle&) = default;
};

struct GetParticles {
  /// [frame X_RS, m, m, rad in practice (def says mm, mm, arcsec)]
  Pose2d mean{};
  /// [def says mm^2]
  double variance = 0;
  std::vector<Particle> particles{};

  friend bool operator==(const GetParticles&, const GetParticles&) = default;
};

void read(Reader& in, Hypoth& m);
void write(Writer& out, const Hypoth& m);
void to_json(std::string& out, const Hypoth& m);
void read(Reader& in, Data& m);
void write(Writer& out, const Data& m);
void to_json(std::string& out, const Data& m);
void read(Reader& in, SetPose& m);
void write(Writer& out, const SetPose& m);
void to_json(std::string& out, const SetPose& m);
void read(Reader& in, Particle& m);
void write(Writer& out, const Particle& m);
void to_json(std::string& out, const Particle& m);
void read(Reader& in, GetParticles& m);
void write(Writer& out, const GetParticles& m);
void to_json(std::string& out, const GetParticles& m);

}  // namespace playhouse::wire::localize
