#pragma once

#include <span>

#include "playhouse/world/generated/changes.h"

namespace playhouse::world {

/// Observer of all changes to a world: every tick, and every batch of
/// changes between two ticks, whatever their origin. Thread: tick.
class RunListener {
 public:
  virtual ~RunListener() = default;
  /// Called after changes between two ticks, with all of them in order; nothing else happened in between.
  virtual void changed(const World& world, std::span<const Change> changes) = 0;
  /// Called after a tick.
  virtual void ticked(const World& world) = 0;
};

}  // namespace playhouse::world
