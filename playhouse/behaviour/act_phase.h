#pragma once

/// ActPhase: how a kind of model executes its commands, in any engine; and
/// Acts, all kinds. A new kind is a new class; generated/acts.h lists them all.

#include <memory>
#include <vector>

#include "playhouse/world/workers.h"
#include "playhouse/world/world.h"

namespace playhouse::behaviour {

class ActPhase {
 public:
  virtual ~ActPhase() = default;

  /// Reads commands and measurements, writes columns of its own kind only; ranges of rows run in parallel.
  virtual void act(world::World& world, world::Workers& workers) = 0;

  /// What rows cannot do in parallel, such as picking up objects. Runs sequentially after act() of all kinds.
  virtual void change(world::World& world) { static_cast<void>(world); }
};

class Acts {
 public:
  void add(std::unique_ptr<ActPhase> phase) { phases_.push_back(std::move(phase)); }

  /// The phase `act`.
  void act(world::World& world, world::Workers& workers) {
    for (const std::unique_ptr<ActPhase>& phase : phases_) phase->act(world, workers);
    for (const std::unique_ptr<ActPhase>& phase : phases_) phase->change(world);
  }

 private:
  std::vector<std::unique_ptr<ActPhase>> phases_;
};

}  // namespace playhouse::behaviour
