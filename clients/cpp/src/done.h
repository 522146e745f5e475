#pragma once

/// What requests and bases have in common whose answers hold nothing.

#include "playhouse_client/device.h"

namespace playhouse::client {

/// Whether a request was carried out, whatever was answered.
template <typename Answer>
Result<void> done(const Result<Answer>& answer) {
  return answer ? Result<void>() : answer.error();
}

/// Closes the device of a base, which is stopped before if it moves. The first of two errors.
template <typename Base>
Result<void> stop_and_close(Base& base, bool moves) {
  Device& device = base.device();
  if (!device.is_open()) return {};
  const Result<void> stopped = moves && !device.gone() ? base.stop() : Result<void>();
  const Result<void> closed = device.close();
  return stopped ? closed : stopped;
}

}  // namespace playhouse::client
