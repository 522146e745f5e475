#pragma once

/// Termination signals: SIGINT (Ctrl-C), SIGTERM, and SIGHUP (terminal closed)
/// unless ignored by nohup. The exit code is 128 plus the signal number.

namespace playhouse::app {

/// Restores immediate termination: there is nothing to
/// clean up. Call at start, and when handlers are removed.
void end_at_once_on_signals();

/// While this object exists, the first signal is recorded, for commands that have
/// to clean up, and the second terminates the program. One instance at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// The recorded signal; 0: none.
  int signal() const;
  /// 128 + the signal, or `otherwise` if none came.
  int exit_code(int otherwise) const { return signal() == 0 ? otherwise : 128 + signal(); }
};

}  // namespace playhouse::app
