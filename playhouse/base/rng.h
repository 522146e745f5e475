#pragma once

/// Counter-based random numbers: a pure function of (seed, tick, stream), so that results
/// depend neither on the order of robots nor on the number of workers. A value type; any
/// thread. Source of the mixing function: splitmix64 (Steele, Lea, Flood 2014).

#include <cstdint>

namespace playhouse {

/// Bijective mixing of 64 bits; close inputs give uncorrelated outputs.
constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

/// Purpose of a stream. Every new use gets an entry here, so that no two uses share a stream.
enum class Purpose : std::uint64_t {
  kStartSpot = 0,      // entity: robot of a scenario; this and the next two with seed 2026 at tick 0
  kStartOrder = 1,     // entity: position in the order
  kStartHeading = 2,   // entity: robot of a scenario
  kController = 3,     // entity: a model; part: which of its controllers
  kBeamBearing = 4,    // entity: a ranger; part: which of its sensors; detail: beam of the sensor
  kRangeNoise = 5,     // entity: a ranger; part: which of its sensors
  kOdometryError = 6,  // entity: a model; at tick 0
  kColor = 7,          // entity: model; with seed 0 at tick 0
  kSequence = 8,       // Rng(seed): numbers that belong to no run
  kTestScene = 9,      // entity: robot
  kFading = 10,        // entity: a radio; part: the one that it hears
  kAgentPlace = 11,    // entity: a model; detail: how often it has been placed
  kPixel = 12,         // entity: a camera; part: its image, that of its right lens, its depths
  kEcho = 13,          // entity: a detector; part: which of its beams
  kDetection = 14,     // entity: a detector; part: the top of what it may notice
  kCustomAct = 15,     // entity: a custom model
  kCustomSense = 16,   // the same
  kMessageLoss = 17,   // entity: a radio; part: the one that sends; detail: which of its messages
  kInertia = 18,       // entity: an imu
  kFix = 19,           // entity: a gps
  kLidarEcho = 20,     // entity: a ranger; part: which of its sensors; detail: beam of all its rings
  kParticle = 21,      // Rng(seed, step): of a filter, for a driver's seed
  kReading = 22,       // entity: a sensor, for each measurement, where its kind has no stream above
  kCount
};

/// Key of an independent sequence per tick: purpose, entity and part. Models are identified by serial number
/// (world/population/serials.h), which does not change when other models are spawned or removed.
struct Stream {
  Purpose purpose;
  std::uint32_t entity = 0, part = 0, detail = 0;
};

class Rng {
 public:
  constexpr Rng(std::uint64_t seed, std::uint64_t tick, Stream stream)
      : state_(mix64(mix64(mix64(mix64(seed) ^ tick) ^ (std::uint64_t{stream.part} << 32 | stream.entity)) ^
                     (std::uint64_t{stream.detail} << 32 | static_cast<std::uint64_t>(stream.purpose)))) {}
  constexpr explicit Rng(std::uint64_t seed) : Rng(seed, 0, {Purpose::kSequence}) {}

  constexpr std::uint64_t bits() { return state_ = mix64(state_); }

  /// Uniform in [0, 1), a multiple of 2^-53.
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Mean 0, variance 1: sum of twelve uniforms minus six
  /// (Irwin-Hall), exactly reproducible on every machine; |value| < 6.
  constexpr double gaussian() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

 private:
  std::uint64_t state_;
};

}  // namespace playhouse
