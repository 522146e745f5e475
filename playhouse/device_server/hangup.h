#pragma once

#include <csignal>

namespace playhouse::device_server {

/// True if SIGHUP (terminal closed) ends the program: nohup ignores it.
inline bool ends_on_hangup() {
  struct sigaction now {};
  sigaction(SIGHUP, nullptr, &now);
  return now.sa_handler != SIG_IGN;
}

}  // namespace playhouse::device_server
