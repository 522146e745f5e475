#pragma once

/// Polled streams over TCP, with the clock of the system.

#include <memory>

#include "playhouse/net/polled/polled.h"

namespace playhouse::net {

/// Has no state. Any thread.
PolledNetwork& system_polled();

/// Takes a connected socket.
std::unique_ptr<PolledStream> polled_stream_of(int socket);

}  // namespace playhouse::net
