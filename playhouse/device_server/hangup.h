#pragma once

#include <csignal>
#include <functional>
#include <utility>

#include "playhouse/net/io_loop.h"

namespace playhouse::device_server {

/// True if SIGHUP (terminal closed) ends the program: nohup ignores it.
inline bool ends_on_hangup() {
  struct sigaction now {};
  sigaction(SIGHUP, nullptr, &now);
  return now.sa_handler != SIG_IGN;
}

/// Calls `caught` for each signal that ends programs. Once for a loop.
inline void on_ending_signals(net::IoLoop& loop, std::function<void(int signal)> caught) {
  if (ends_on_hangup()) {
    loop.on_signal({SIGINT, SIGTERM, SIGHUP}, std::move(caught));
  } else {
    loop.on_signal({SIGINT, SIGTERM}, std::move(caught));
  }
}

}  // namespace playhouse::device_server
