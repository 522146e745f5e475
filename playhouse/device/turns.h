#pragma once

/// Turns: in which order clients may change the world, where that must not depend on whose bytes arrive
/// first.

#include <functional>

#include "playhouse/device/caller.h"

namespace playhouse::device {

class Turns {
 public:
  virtual ~Turns() = default;

  /// What the client says may be carried out now. What only asks need not wait for it. Any thread.
  virtual bool may_act(const Caller& caller) const = 0;

  /// `changed` is called on any thread whenever somebody may act who might not before. Before the run.
  virtual void when_changed(std::function<void()> changed) = 0;
};

}  // namespace playhouse::device
