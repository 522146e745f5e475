#pragma once

/// Agents: the robots of a world as learning programs see them, all at once: a velocity each in, what each
/// senses out, as columns in shared memory. An agent is a robot at the top of the world with a range finder.
/// Thread: the tick thread.

#include <cstdint>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/gym/shared_columns.h"
#include "playhouse/drivers/simulated/simulation.h"
#include "playhouse/world/control.h"

namespace playhouse::drivers::gym {

class Agents {
 public:
  explicit Agents(Simulation& simulation) : simulation_(simulation) {}

  /// Finds the agents, makes the columns and has the sensors measure from the first tick on. Fails where
  /// there is no agent, and where their range finders have different numbers of beams.
  Result<void> begin();
  const SharedColumns& columns() const { return columns_; }

  /// Carries out the actions. Agents whose `reset` is set are put to a place of the start first, one that
  /// nobody is at, chosen at random by seed and tick, and stand there.
  void act();
  /// Puts each agent to a place of its own, one of those of the start, by the seed; all stand there.
  void reset_all();
  /// What everybody senses now, into the columns.
  void observe();

 private:
  struct Agent {
    world::ModelId model, ranger;
    geom::Pose start;   // X_WM, in the world's file
    double radius = 0;  // m, of a circle about its frame that holds it however it turns
    std::uint32_t placed = 0;
    world::Use wheels, sensor;
  };
  void find();
  void use_all(world::World& world);
  void use_again(world::World& world);
  std::uint32_t beams_of(const Agent& agent) const;
  void place(std::size_t agent);
  void stand(std::size_t agent);
  bool is_free(const geom::Pose& place, std::size_t agent) const;

  Simulation& simulation_;
  std::vector<Agent> agents_;
  std::uint32_t beams_ = 0;
  SharedColumns columns_;
};

}  // namespace playhouse::drivers::gym
