#pragma once

/// ActPhase: what a kind of model does with its commands, whatever space it is in; and Acts, all kinds. A new
/// kind is a class of its own; generated/acts.h lists them all.

#include <memory>
#include <vector>

#include "playhouse/world/workers.h"
#include "playhouse/world/world.h"

namespace playhouse::behaviour {

class ActPhase {
 public:
  virtual ~ActPhase() = default;

  /// Reads commands and what was sensed, writes columns of its own kind alone, over ranges of rows.
  virtual void act(world::World& world, world::Workers& workers) = 0;

  /// What rows cannot do side by side, such as taking things up. Runs alone, when all kinds have acted.
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
