#pragma once

/// Air: the temperature of the air anywhere in a world, with the models that are warm or cold in it.
///
/// Source: each warm model is a ball of constant temperature in air that conducts heat and rests. Its excess e
///   over the air far away is harmonic outside of the ball, so at the distance d it is e r / d for a radius r,
///   and fields of several balls add up (Carslaw and Jaeger, "Conduction of Heat in Solids", 1959, 9.1). Air
///   that cools with height does so linearly, as in the troposphere (ISO 2533).

#include <cstddef>
#include <vector>

#include "playhouse/geom/orientation.h"
#include "playhouse/world/world.h"

namespace playhouse::senses {

inline constexpr double kAbsoluteZero = -273.15;  // degC

/// The air far from all models with heat.
struct OpenAir {
  double ambient = 0;  // degC, at height 0
  double lapse = 0;    // K/m
};

class Air {
 public:
  /// To be called again when the population has changed. Without sensors nothing is looked for.
  void populate(const world::World& world, std::size_t sensors);
  /// To be called in each tick with measurements, before them.
  void begin_tick(const world::World& world);
  /// At the middle of a model's body; may be below kAbsoluteZero. Any thread.  [degC]
  double temperature(const world::World& world, world::ModelRow model, const OpenAir& open) const;

 private:
  /// A warm or cold model.
  struct Ball {
    geom::Vec3 middle;
    double excess = 0;  // of its surface times its radius  [K m]
    double radius = 0;
  };
  std::vector<world::ModelRow> warm_;
  std::vector<Ball> balls_;  // where these are in this tick
};

}  // namespace playhouse::senses
