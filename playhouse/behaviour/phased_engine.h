#pragma once

/// PhasedEngine: the tick that all engines share, as an order of phases. Each phase reads what earlier ones
/// froze and writes its own columns. An engine adds the phases that know about space. Thread: the tick
/// thread.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/behaviour/act_phase.h"
#include "playhouse/behaviour/energy.h"
#include "playhouse/world/engine.h"
#include "playhouse/world/workers.h"

namespace playhouse::behaviour {

class PhasedEngine : public world::Engine {
 public:
  /// The scene must outlive it.
  PhasedEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers);

  void step() final;
  world::World& world() final { return world_; }
  world::Workers& workers() final { return workers_; }
  world::PhysicsShapes physics_shapes() final;

 protected:
  /// Takes in who came, went, became part of another or was put elsewhere since the last call.
  virtual void ingest(std::span<const world::Change> changes) = 0;
  /// Moves what has a velocity, from the pose of the last tick to that of this one, and says what stalled;
  /// robots believe what follows (see positions.X_OM).
  virtual void move() = 0;
  /// Measures with what is subscribed and due for `tick`.
  virtual void sense(std::uint64_t tick) = 0;

  /// See Engine::physics_shapes(); all changes have been taken in.
  virtual world::PhysicsShapes shapes() const { return {}; }

  /// Appends the models of other trees whose bodies touch or overlap that of `model`, whatever their heights,
  /// and that are `wanted` (by row of the models): ascending, each once.
  virtual void touching(world::ModelRow model, std::span<const std::uint8_t> wanted,
                        std::vector<std::uint32_t>& out) const = 0;

  world::World world_;
  world::Workers workers_;

 private:
  void decide();
  void deliver();
  void take_changes();
  void ingest_changes();
  void filter();
  void flow();
  void freeze();

  Acts acts_;
  Energy energy_;
  std::vector<std::uint32_t> touching_;  // the one that charges others
  // Of world_.changes: what the last tick had not seen, and what ingest() has not.
  std::uint64_t next_change_ = 0, next_ingested_ = 0;
};

}  // namespace playhouse::behaviour
