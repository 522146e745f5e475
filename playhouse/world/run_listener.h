#pragma once

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Observer of all changes to a world: every tick, and every batch of
/// changes between two ticks, whatever their origin. Thread: tick.
class RunListener {
 public:
  virtual ~RunListener() = default;
  /// Called before anything other than a tick changes the world.
  virtual void before_changes(const World& world) = 0;
  /// Called after it; nothing else happened in between.
  virtual void after_changes(const World& world) = 0;
  /// Called after a tick.
  virtual void ticked(const World& world) = 0;
};

}  // namespace playhouse::world
