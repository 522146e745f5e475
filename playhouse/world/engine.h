#pragma once

#include <cstdint>

#include "playhouse/world/physics_shapes.h"
#include "playhouse/world/workers.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// What the bridge and the program see of an engine, whichever it is. Thread: the tick thread.
class Engine {
 public:
  virtual ~Engine() = default;

  /// One tick of scene().interval: decide .. freeze (behaviour/phased_engine.h).
  virtual void step() = 0;

  /// The state; change it only between steps, with the functions of world.h.
  virtual World& world() = 0;

  /// The threads that share the rows of a phase; between steps, for who has much to do with the state.
  virtual Workers& workers() = 0;

  /// Rays cast since the start, for benches.
  virtual std::uint64_t rays() const = 0;

  /// What it takes bodies for as they stand now; nothing where it does not tell. Between steps.
  virtual PhysicsShapes physics_shapes() { return {}; }
};

}  // namespace playhouse::world
