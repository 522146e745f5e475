#pragma once

/// Energy: the phase that drains and charges batteries. A subscribed model draws power as its
/// kind or its file says from its own battery, otherwise from that of its nearest ancestor
/// with one; robots draw more while they drive. An empty battery limits what is drawn and
/// stops nothing. Then chargers charge the models in contact, in row order; contact is
/// determined by the engine. Free of cost if no model has a battery. Thread: the tick thread.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/traits.h"
#include "playhouse/world/workers.h"

namespace playhouse::behaviour {

class Energy {
 public:
  /// A charger.
  struct Giver {
    world::ModelRow model;
    world::PackRow pack;  // its source
    double watts = 0;     // W, at most
  };

  /// Drains all batteries for one tick, in parallel by battery: writes world.packs.
  void drain(world::World& world, world::Workers& workers);
  /// Chargers with a battery in reach, ascending; of the population of the last drain().
  std::span<const Giver> givers() const { return givers_; }
  /// Whether each model can be charged: enabled, with a battery in reach (models; empty without chargers).
  const world::ByModel<std::uint8_t>& takers() const { return takers_; }

  /// Whether it charges in this tick: subscribed, enabled, battery not empty.
  static bool gives(const world::World& world, const Giver& giver);
  /// Transfers one tick's energy to each of these models, in order, within the source and the capacities.
  static void charge(world::World& world, const Giver& giver, std::span<const world::ModelRow> takers);

 private:
  /// A consumer: a model with a battery in reach.
  struct Load {
    world::ModelRow model;
    double watts = 0;             // W, independent of motion
    world::PositionRow position;  // none: it does not drive
    double watts_per_speed = 0;   // W s/m and W s/rad, of a robot's speed
  };

  void populate(const world::World& world);
  double drawn_by(const world::World& world, const Load& load) const;
  void drain(world::World& world, world::PackRow pack) const;
  void find_givers(const world::World& world, const world::ByModel<world::PackRow>& pack);

  std::uint64_t population_ = 0;                       // of the rows below; 0: none yet
  std::vector<Load> loads_;                            // by battery, then by model
  ByRow<world::PackTable, std::uint32_t> first_load_;  // of each battery (batteries + 1)
  std::vector<Giver> givers_;
  world::ByModel<std::uint8_t> takers_;
};

}  // namespace playhouse::behaviour
