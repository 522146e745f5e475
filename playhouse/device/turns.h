#pragma once

/// Turns: deterministic order of clients' changes
/// to the world, independent of arrival order.

#include <functional>

#include "playhouse/device/caller.h"

namespace playhouse::device {

class Turns {
 public:
  virtual ~Turns() = default;

  /// True if the client's modifying messages may be executed now; queries need not wait. Any thread.
  virtual bool may_act(const Caller& caller) const = 0;

  /// Adds a callback for when a client may become able to act; called on any thread. Before the run.
  virtual void when_changed(std::function<void()> changed) = 0;
};

}  // namespace playhouse::device
