#pragma once

#include <functional>

#include "playhouse/world/world.h"

namespace playhouse::world {

/// How a running simulation relates to the wall clock.
struct Pace {
  bool paused = false;
  double speed = 1;             // wanted, times real time; 0: as fast as possible
  double real_time_factor = 0;  // measured over the last second
};

/// Control over a running simulation, for viewers and devices. Every function may be called from any thread
/// and returns at once; what it asks for happens on the tick thread before the next tick, also while paused.
class Control {
 public:
  virtual ~Control() = default;
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
};

}  // namespace playhouse::world
