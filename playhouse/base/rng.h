#pragma once

/// Random numbers as a pure function of (seed, tick, entity, stream), so that a result depends neither on the
/// order in which robots are computed nor on the number of workers. A value type; any thread.
/// Source of the mixing function: splitmix64 (Steele, Lea, Flood 2014).

#include <cstdint>

namespace playhouse {

/// Mixes 64 bits into 64 bits; neighbouring inputs give unrelated outputs.
constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

class Rng {
 public:
  constexpr Rng(std::uint64_t seed, std::uint64_t tick, std::uint64_t entity, std::uint64_t stream)
      : state_(mix64(mix64(mix64(mix64(seed) ^ tick) ^ entity) ^ stream)) {}

  constexpr std::uint64_t bits() { return state_ = mix64(state_); }

  /// Uniform in [0, 1), a multiple of 2^-53.
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Mean 0, variance 1: sum of twelve uniforms less six (Irwin-Hall), exact arithmetic on every machine; |value| < 6.
  constexpr double gaussian() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

 private:
  std::uint64_t state_;
};

}  // namespace playhouse
