#include "playhouse/app/interrupt.h"

#include <unistd.h>

#include <csignal>

#include "playhouse/device_server/hangup.h"

namespace playhouse::app {
namespace {

volatile std::sig_atomic_t caught = 0;  // global, for the signal handler

void end_at_once(int signal) {
  _exit(128 + signal);
}

void note(int signal) {
  if (caught == 0) {
    caught = signal;
  } else if (signal != SIGHUP) {  // a closed terminal may send it twice
    end_at_once(signal);
  }
}

void handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // without SA_RESTART: blocking calls are interrupted
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  if (device_server::ends_on_hangup()) sigaction(SIGHUP, &action, nullptr);
}

}  // namespace

void end_at_once_on_signals() {
  handle(end_at_once);
}

Interrupt::Interrupt() {
  caught = 0;
  handle(note);
}

Interrupt::~Interrupt() {
  end_at_once_on_signals();
}

int Interrupt::signal() const {
  return caught;
}

}  // namespace playhouse::app
