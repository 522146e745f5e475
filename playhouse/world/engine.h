#pragma once

#include <cstdint>

#include "playhouse/world/division.h"
#include "playhouse/world/physics_shapes.h"
#include "playhouse/world/workers.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

struct EngineOptions {
  std::uint64_t seed = 1;
  unsigned workers = 1;  // threads; the result does not depend on it
};

/// The interface of an engine to the program. Thread: the tick thread.
class Engine {
 public:
  virtual ~Engine() = default;

  /// One tick of scene().interval: decide .. freeze (behaviour/phased_engine.h).
  virtual void step() = 0;

  /// The same without the other machines that take part in a run: for ticks that did happen, computed once
  /// more.
  virtual void step_alone() { step(); }

  /// The state; change it only between steps, with the functions of world.h.
  virtual World& world() = 0;

  /// The workers of the phases; between steps also for other expensive work on the state.
  virtual Workers& workers() = 0;

  /// Shares work of the following ticks with other nodes of a cluster, which have the same state; null: no
  /// longer. An engine may share none. Between steps.
  virtual void divide(Division* division) { static_cast<void>(division); }

  /// Rays cast since the start, for benches.
  virtual std::uint64_t rays() const = 0;

  /// Collision shapes at their present poses; empty if the engine does not provide them. Between steps.
  virtual PhysicsShapes physics_shapes() { return {}; }
};

}  // namespace playhouse::world
