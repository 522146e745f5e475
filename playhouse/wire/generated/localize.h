// Generated from interfaces/025_localize.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Tells where the robot may be on a map, as weighted guesses.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::localize {

inline constexpr std::uint16_t kCode = 25;

// Subtypes of messages.
/// The guesses, the likeliest first.
inline constexpr std::uint8_t kDataHypoths = 1;
/// Tells the driver where the robot is.
inline constexpr std::uint8_t kReqSetPose = 1;
/// Asks for the particles of the driver's filter.
inline constexpr std::uint8_t kReqGetParticles = 2;

/// One guess.
struct Hypoth {
  /// Centre of the guess. [frame X_MR, m, m, rad]
  Pose2d mean{};
  /// Spread: xx, yy, aa, xy, ya, xa. [m^2, m^2, rad^2, m^2, m rad, m rad]
  std::array<double, 6> cov{};
  /// Weight; all weights together make 1. [1]
  double alpha = 0;

  friend bool operator==(const Hypoth&, const Hypoth&) = default;
};

/// The guesses.
struct Data {
  /// How many sensor readings wait to be used.
  std::uint32_t pending_count = 0;
  /// Time of the last reading that was used. [s]
  double pending_time = 0;
  std::vector<Hypoth> hypoths{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// Where the robot is.
struct SetPose {
  /// Centre of the guess. [frame X_MR, m, m, rad]
  Pose2d mean{};
  /// Spread: xx, yy, aa, xy, ya, xa. [m^2, m^2, rad^2, m^2, m rad, m rad]
  std::array<double, 6> cov{};

  friend bool operator==(const SetPose&, const SetPose&) = default;
};

/// One particle.
struct Particle {
  /// Where the particle believes the robot to be. [frame X_MR, m, m, rad]
  Pose2d pose{};
  /// Weight. [1]
  double alpha = 0;

  friend bool operator==(const Particle&, const Particle&) = default;
};

/// The particles of the filter.
struct GetParticles {
  /// Of the best guess. [frame X_MR, m, m, rad]
  Pose2d mean{};
  /// Of the best guess. [m^2]
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
