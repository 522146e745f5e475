#pragma once

#include "playhouse/world/world.h"

namespace playhouse::world {

/// Who hears of all that happens to a world: every tick, and every batch of changes between two ticks, from
/// whomever they come and whatever they do. Thread: tick.
class Witness {
 public:
  virtual ~Witness() = default;
  /// Something other than a tick is about to change the world.
  virtual void before_changes(const World& world) = 0;
  /// It is done; nothing else happened meanwhile.
  virtual void after_changes(const World& world) = 0;
  /// A tick is done.
  virtual void ticked(const World& world) = 0;
};

}  // namespace playhouse::world
