#pragma once

/// PhasedEngine: the tick that all engines share, a sequence of phases. Each
/// phase reads what earlier ones froze and writes its own columns. Derived
/// engines add the phases that involve geometry. Thread: the tick thread.

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
  void divide(world::Division* division) final { division_ = division; }

 protected:
  /// Updates derived tables for models spawned, removed, attached or teleported since the last call.
  virtual void ingest(std::span<const world::Event> events) = 0;
  /// Moves models with a velocity from their pose at the last tick to that of
  /// this one, sets stall flags and updates odometry (see positions.X_OM).
  virtual void move() = 0;
  /// Measures with the sensors that are subscribed and due at `tick`.
  virtual void sense(std::uint64_t tick) = 0;

  /// See Engine::physics_shapes(); called after all events have been ingested.
  virtual world::PhysicsShapes shapes() const { return {}; }

  /// Appends the models of other trees whose bodies touch or overlap that of `model`, whatever
  /// their heights, and that are `wanted` (by row of the models): ascending, without duplicates.
  virtual void touching(world::ModelRow model, const world::ByModel<std::uint8_t>& wanted,
                        std::vector<world::ModelRow>& out) const = 0;

  world::World world_;
  world::Workers workers_;
  world::Division* division_ = nullptr;  // of a cluster; null: all work is done here

 private:
  void decide();
  void deliver();
  void take_events();
  void ingest_events();
  void filter();
  void flow();
  void freeze();

  Acts acts_;
  Energy energy_;
  std::vector<world::ModelRow> touching_;  // models in contact with a charger: scratch
  // Cursors into world_.events: next for the tick, next for ingest().
  std::uint64_t next_event_ = 0, next_ingested_ = 0;
};

}  // namespace playhouse::behaviour
