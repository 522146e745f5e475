#include "playhouse/app/interrupt.h"

#include <csignal>

namespace playhouse::app {
namespace {

volatile std::sig_atomic_t caught = 0;  // a signal handler can reach nothing but a global

void note(int signal) {
  caught = signal;
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // without SA_RESTART: waiting calls return
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  caught = 0;
  handle(SIGINT, note);
  handle(SIGTERM, note);
}

Interrupt::~Interrupt() {
  handle(SIGINT, SIG_DFL);
  handle(SIGTERM, SIG_DFL);
}

int Interrupt::signal() const {
  return caught;
}

}  // namespace playhouse::app
