// Generated from interfaces/025_localize.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Localization on a map: weighted hypotheses of the robot's pose.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::localize {

inline constexpr std::uint16_t kCode = 25;

// Subtypes of messages.
/// The hypotheses, the most likely first.
inline constexpr std::uint8_t kDataHypoths = 1;
/// Sets the robot's pose estimate.
inline constexpr std::uint8_t kReqSetPose = 1;
/// Requests the particles of the driver's filter.
inline constexpr std::uint8_t kReqGetParticles = 2;

/// A hypothesis.
struct Hypoth {
  /// Mean of the hypothesis. [frame X_MR, m, m, rad]
  Pose2d mean{};
  /// Spread: xx, yy, aa, xy, ya, xa. [m^2, m^2, rad^2, m^2, m rad, m rad]
  std::array<double, 6> cov{};
  /// Weight; the weights sum to 1. [1]
  double alpha = 0;

  friend bool operator==(const Hypoth&, const Hypoth&) = default;
};

/// The hypotheses.
struct Data {
  /// Number of queued sensor readings.
  std::uint32_t pending_count = 0;
  /// Time of the last processed reading. [s]
  double pending_time = 0;
  std::vector<Hypoth> hypoths{};

  friend bool operator==(const Data&, const Data&) = default;
};

/// Pose of the robot.
struct SetPose {
  /// Mean of the hypothesis. [frame X_MR, m, m, rad]
  Pose2d mean{};
  /// Spread: xx, yy, aa, xy, ya, xa. [m^2, m^2, rad^2, m^2, m rad, m rad]
  std::array<double, 6> cov{};

  friend bool operator==(const SetPose&, const SetPose&) = default;
};

/// One particle.
struct Particle {
  /// The particle's estimate of the robot's pose. [frame X_MR, m, m, rad]
  Pose2d pose{};
  /// Weight. [1]
  double alpha = 0;

  friend bool operator==(const Particle&, const Particle&) = default;
};

/// The particles of the filter.
struct GetParticles {
  /// Of the most likely hypothesis. [frame X_MR, m, m, rad]
  Pose2d mean{};
  /// Of the most likely hypothesis. [m^2]
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
