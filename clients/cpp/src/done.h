#pragma once

/// Helpers for requests without a result, and for closing bases.

#include "playhouse_client/device.h"

namespace playhouse::client {

/// Discards the answer's body: success, or the error.
template <typename Answer>
Result<void> done(const Result<Answer>& answer) {
  return answer ? Result<void>() : answer.error();
}

/// Stops the base if it `moves`, then closes its device. Returns the first error.
template <typename Base>
Result<void> stop_and_close(Base& base, bool moves) {
  Device& device = base.device();
  if (!device.is_open()) return {};
  const Result<void> stopped = moves && !device.gone() ? base.stop() : Result<void>();
  const Result<void> closed = device.close();
  return stopped ? closed : stopped;
}

}  // namespace playhouse::client
