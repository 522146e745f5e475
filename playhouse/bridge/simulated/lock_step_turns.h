#pragma once

#include <functional>
#include <utility>

#include "playhouse/device/turns.h"
#include "playhouse/run/lock_step.h"

namespace playhouse::drivers {

/// The turns of a world in lock-step, for the server of its clients.
class LockStepTurns final : public device::Turns {
 public:
  explicit LockStepTurns(run::LockStep& lock_step) : lock_step_(lock_step) {}

  bool may_act(const device::Caller& caller) const override { return lock_step_.may_act(&caller); }
  void when_changed(std::function<void()> changed) override { lock_step_.when_changed(std::move(changed)); }

 private:
  run::LockStep& lock_step_;
};

}  // namespace playhouse::drivers
