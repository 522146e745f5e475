#pragma once

/// Energy: the phase in which models draw from batteries. A subscribed model draws what its kind or its words
/// say from its own battery, else from that of the nearest model around it; robots draw more while they
/// drive. What a battery has not got is not drawn, and nothing stops for it. A tick costs nothing where no
/// model has a battery. Thread: the tick thread.

#include <cstdint>
#include <vector>

#include "playhouse/world/traits.h"
#include "playhouse/world/workers.h"

namespace playhouse::behaviour {

class Energy {
 public:
  /// One tick's worth, of batteries side by side on any number of workers: writes world.packs.
  void flow(world::World& world, world::Workers& workers);

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

  std::uint64_t population_ = 0;           // that the rows below are of; 0: none yet
  std::vector<Load> loads_;                // by battery, then by model
  std::vector<std::uint32_t> first_load_;  // of each battery (batteries + 1)
};

}  // namespace playhouse::behaviour
