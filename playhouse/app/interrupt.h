#pragma once

namespace playhouse::app {

/// Catches SIGINT and SIGTERM for commands that talk to a server, so that they can end cleanly. One at a
/// time.
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
