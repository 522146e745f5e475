#pragma once

/// Agents: vectorised environment for learning programs: a velocity
/// per robot in, observations out, as columns in shared memory. An
/// agent is a root robot with a range finder. Thread: the tick thread.

#include <cstdint>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/bridge/gym/shared_columns.h"
#include "playhouse/run/simulation.h"
#include "playhouse/world/control.h"

namespace playhouse::drivers::gym {

class Agents {
 public:
  explicit Agents(run::Simulation& simulation) : simulation_(simulation) {}

  /// Finds the agents, allocates the columns and subscribes the sensors from the first tick
  /// on. Fails if there are no agents, or if their range finders differ in number of beams.
  Result<void> begin();
  const SharedColumns& columns() const { return columns_; }

  /// Applies the actions. Agents whose `reset` is set are first
  /// moved to a free start pose, random by seed and tick, at rest.
  void act(world::Journal& journal);
  /// Resets all agents: assigns start poses to them, a permutation by the seed, at rest.
  void reset_all(world::Journal& journal);
  /// Writes the observations of all agents to the columns.
  void observe();

 private:
  struct Agent {
    world::ModelId model, ranger;
    geom::Pose start;   // X_WM in the world file
    double radius = 0;  // m, bounding circle about its frame, at any heading
    std::uint32_t placed = 0;
    world::Use wheels, sensor;
  };
  void find();
  void use_all(world::Journal& journal);
  void use_again(world::Journal& journal);
  std::uint32_t beams_of(const Agent& agent) const;
  void place(world::Journal& journal, std::size_t agent);
  static void place_at(world::Journal& journal, world::ModelId model, const geom::Pose& at);
  bool is_free(const geom::Pose& place, std::size_t agent) const;

  run::Simulation& simulation_;
  std::vector<Agent> agents_;
  std::uint32_t beams_ = 0;
  SharedColumns columns_;
};

}  // namespace playhouse::drivers::gym
