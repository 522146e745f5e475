#pragma once

/// Random numbers as a pure function of (seed, tick, stream), so that a result depends neither on the order
/// in which robots are computed nor on the number of workers. A value type; any thread. Source of the mixing
/// function: splitmix64 (Steele, Lea, Flood 2014).

#include <cstdint>

namespace playhouse {

/// Mixes 64 bits into 64 bits; neighbouring inputs give unrelated outputs.
constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

/// What numbers are drawn for. Whoever draws for something new adds it here, so that no two draw the same.
enum class Purpose : std::uint64_t {
  kStartSpot = 0,      // row: robot of a scenario; this and the next two with seed 2026 at tick 0
  kStartOrder = 1,     // row: place in the order
  kStartHeading = 2,   // row: robot of a scenario
  kController = 3,     // row: model; part: which of its controllers
  kBeamBearing = 4,    // row: sensor; part: beam of the sensor
  kRangeNoise = 5,     // row: sensor
  kOdometryError = 6,  // row: model; at tick 0
  kColor = 7,          // row: model; with seed 0 at tick 0
  kSequence = 8,       // Rng(seed): numbers that belong to no run
  kTestScene = 9,      // row: robot
  kCount
};

/// A sequence of numbers of its own in every tick of a run: what for, and for which row (and part of it).
struct Stream {
  Purpose purpose;
  std::uint32_t row = 0, part = 0;

  constexpr std::uint64_t entity() const { return std::uint64_t{part} << 32 | row; }
};

class Rng {
 public:
  constexpr Rng(std::uint64_t seed, std::uint64_t tick, Stream stream)
      : state_(mix64(mix64(mix64(mix64(seed) ^ tick) ^ stream.entity()) ^
                     static_cast<std::uint64_t>(stream.purpose))) {}
  constexpr explicit Rng(std::uint64_t seed) : Rng(seed, 0, {Purpose::kSequence}) {}

  constexpr std::uint64_t bits() { return state_ = mix64(state_); }

  /// Uniform in [0, 1), a multiple of 2^-53.
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Mean 0, variance 1: sum of twelve uniforms less six (Irwin-Hall), exact arithmetic on every machine;
  /// |value| < 6.
  constexpr double gaussian() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

 private:
  std::uint64_t state_;
};

}  // namespace playhouse
