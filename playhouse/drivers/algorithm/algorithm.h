#pragma once

/// Algorithm: what one driver of algorithms computes, and nothing else. It registers in its constructor what it
/// reads, takes and answers with its shell (shell.h), which calls it.

#include <cstdint>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/site_world.h"

namespace playhouse::drivers {

class Algorithm {
 public:
  virtual ~Algorithm() = default;

  /// Fails if it can do nothing with the model of the first device that it uses, with what the device "...". In
  /// a simulated world, before it runs.
  virtual Result<void> fits(const SiteWorld&, device::Address) const { return {}; }

  // Io thread.

  /// The first of its devices was opened, and all that it uses are open.
  virtual void opened() {}
  /// The last was closed, or one that it uses has retired. What it uses is still open: it stops what it moves.
  virtual void closing() {}
  /// What it uses is closed.
  virtual void closed() {}

  /// There are new data of its subscriptions; data appended to `more` join the batch. Publishing thread.
  virtual void take_news(std::vector<device::Publication>& more) = 0;

  // Tick thread.

  /// A tick of a simulated world is done.
  virtual void ticked() {}
  /// The run goes on from there; steps posted before were dropped. The seed is the driver's own.
  virtual void rewound(const Moment&) {}
  /// The world put its robot elsewhere, as by RESET.
  virtual void placed() {}
};

}  // namespace playhouse::drivers
