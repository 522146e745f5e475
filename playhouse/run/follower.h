#pragma once

/// Follower: whoever follows a run, by Simulation::follow(): devices, recordings, pages, observers, other
/// machines. Each function has an empty default. All but works are called on the tick thread, which waits for
/// them, in the order of follow(): they must be cheap.

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "playhouse/run/publisher_thread.h"
#include "playhouse/world/control.h"
#include "playhouse/world/generated/changes.h"
#include "playhouse/world/world.h"

namespace playhouse::run {

class Follower {
 public:
  virtual ~Follower() = default;

  /// Each entry of world.events in order: between any two requests, and after a tick before anything else,
  /// so that what is decided here is the same in every run. May add followers.
  virtual void happened(const world::World&, const world::Event&) {}
  /// The changes between two ticks, in order, once all of them are made.
  virtual void changed(const world::World&, std::span<const world::Change>) {}
  /// After each tick.
  virtual void ticked(const world::World&) {}
  /// Something to do with the world as it is now, by reading, while the tick thread waits for its next tick
  /// (publisher_thread.h); none: nothing. Asked after each tick and after changes, and at 10 Hz while
  /// paused. Done before anything changes the world.
  virtual std::optional<Work> work(const world::World&, const world::Pace&) { return {}; }
  /// True if it wants shown().
  virtual bool watches() const { return false; }
  /// On those occasions, when the works of all followers are done: the tick waits for them.
  virtual void shown(const world::World&, const world::Pace&) {}
};

/// A follower that calls this for each event.
std::shared_ptr<Follower> on_event(std::function<void(const world::World&, const world::Event&)> call);
/// A follower that calls this whenever the world is shown.
std::shared_ptr<Follower> on_show(std::function<void(const world::World&, const world::Pace&)> call);

}  // namespace playhouse::run
