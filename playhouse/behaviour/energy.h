#pragma once

/// Energy: the phase in which models draw from batteries. A model that is used draws what its kind or its
/// words say from its own battery, else from that of the nearest model around it; robots draw more while they
/// drive. What a battery has not got is not drawn, and nothing stops for it. Then models charge those that
/// touch them, in the order of the models; who does is for the engine to say. A tick costs nothing where no
/// model has a battery. Thread: the tick thread.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/traits.h"
#include "playhouse/world/workers.h"

namespace playhouse::behaviour {

class Energy {
 public:
  /// A model that charges others.
  struct Giver {
    world::ModelRow model;
    world::PackRow pack;  // from which
    double watts = 0;     // W, at most
  };

  /// What is drawn in one tick, of batteries side by side on any number of workers: writes world.packs.
  void drain(world::World& world, world::Workers& workers);
  /// Those with a battery in reach, ascending; of the population of the last drain().
  std::span<const Giver> givers() const { return givers_; }
  /// Whether each model can be charged: it says so and has a battery in reach (models; empty without givers).
  std::span<const std::uint8_t> takers() const { return takers_; }

  /// Whether it charges others in this tick: it is subscribed, allowed to and has something to give.
  static bool gives(const world::World& world, const Giver& giver);
  /// One tick's worth to each of these takers, in their order, as far as it lasts and as they have room.
  static void charge(world::World& world, const Giver& giver, std::span<const std::uint32_t> takers);

 private:
  /// A model that has a battery in reach.
  struct Load {
    std::uint32_t model = 0;
    double watts = 0;            // W, however it moves
    std::uint32_t position = 0;  // its row there, or Row::kNone
    double watts_per_speed = 0;  // W s/m and W s/rad, of one that drives
  };

  void populate(const world::World& world);
  double drawn_by(const world::World& world, const Load& load) const;
  void drain(world::World& world, std::size_t pack) const;
  void find_givers(const world::World& world, std::span<const world::PackRow> pack);

  std::uint64_t population_ = 0;           // that the rows below are of; 0: none yet
  std::vector<Load> loads_;                // by battery, then by model
  std::vector<std::uint32_t> first_load_;  // of each battery (batteries + 1)
  std::vector<Giver> givers_;
  std::vector<std::uint8_t> takers_;
};

}  // namespace playhouse::behaviour
