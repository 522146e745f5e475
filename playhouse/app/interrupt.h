#pragma once

/// The signals that end the program: SIGINT (Ctrl-C), SIGTERM, and SIGHUP (the terminal was closed) unless
/// nohup has it ignored. The exit code is 128 and the number of the signal.

namespace playhouse::app {

/// From now on they end the program at once: there is nothing to clean. Call first, and again when those who
/// caught them no longer look.
void end_at_once_on_signals();

/// Whether SIGHUP ends the program.
bool ends_on_hangup();

/// While it lives, the first signal is noted for commands that have something to clean, and the second ends
/// the program at once. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// The signal that came; 0: none yet.
  int signal() const;
  /// 128 + the signal, or `otherwise` if none came.
  int exit_code(int otherwise) const { return signal() == 0 ? otherwise : 128 + signal(); }
};

}  // namespace playhouse::app
