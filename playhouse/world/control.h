#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// How a running simulation relates to the wall clock.
struct Pace {
  bool paused = false;
  double speed = 1;             // wanted, times real time; 0: as fast as possible
  double real_time_factor = 0;  // measured over the last second
};

/// Instants of a run whose states are kept.
struct Past {
  std::vector<std::uint64_t> ticks;  // ascending
  std::string why_none;              // that no state can be taken, as one line; else empty
};

/// Control over a running simulation, for viewers and devices. Every function may be called from any thread
/// and returns at once; what it asks for happens on the tick thread before the next tick, also while paused.
class Control {
 public:
  virtual ~Control() = default;
  /// Why nobody may change the world, as one line; empty: people may.
  virtual std::string why_fixed() const { return {}; }
  virtual void pause() = 0;
  virtual void resume() = 0;
  /// One tick, then paused.
  virtual void step_once() = 0;
  virtual void set_speed(double times_real_time) = 0;
  /// Sets the velocity of a robot's wheels, as a client's command would: the newest before a tick counts.
  /// Finite.
  virtual void drive(ModelId robot, const geom::Twist& velocity) = 0;
  /// Runs `change` on the tick thread between two ticks. False: the queue is full (limits::kRequestQueue),
  /// nothing happens. `robot`, if any, is whom the change concerns: what it was told before is carried out
  /// before.
  virtual bool post(std::function<void(World&)> change, ModelId robot = {}) = 0;

  /// From now on states are kept, or no more; those that are there stay.
  virtual void record(bool on) = 0;
  /// The states that are kept. Never null.
  virtual std::shared_ptr<const Past> past() const = 0;
  /// The world becomes that of the kept instant nearest to the tick, earlier or later than now, and goes on
  /// from there: a kReload in its changes. Does nothing while no state is kept.
  virtual void rewind(std::uint64_t tick) = 0;
  /// Incarnation count, incremented when rewind() re-creates the model: who used it before does so no more.
  /// Tick thread.
  virtual std::uint64_t life(ModelId model) const = 0;
};

/// One subscription of a model, which ends with the model, also where that comes back; or that of somebody
/// who watches it. Tick thread.
class Use {
 public:
  /// Does nothing if there is no such model.
  void begin(World& world, const Control& control, ModelId model) { begin(world, control, model, subscribe); }
  void watch(World& world, const Control& control, ModelId model) {
    begin(world, control, model, world::watch);
    watches_ = true;
  }
  /// The model; none if it has gone, or the use never began.
  ModelRow end(World& world, const Control& control) {
    const ModelRow row = life_ && *life_ == control.life(model_) ? world.row(model_) : ModelRow{};
    life_.reset();
    if (row) watches_ ? unwatch(world, row) : unsubscribe(world, row);
    return row;
  }

 private:
  void begin(World& world, const Control& control, ModelId model, void (&join)(World&, ModelRow)) {
    const ModelRow row = world.row(model);
    if (!row) return;
    join(world, row);
    model_ = model;
    life_ = control.life(model);
  }

  ModelId model_;
  std::optional<std::uint64_t> life_;  // in which it began; none: it has not
  bool watches_ = false;
};

}  // namespace playhouse::world
