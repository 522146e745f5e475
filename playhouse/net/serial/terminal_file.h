#pragma once

/// Descriptors of serial ports and pseudo-terminals. Internal to net.

#include <string>

#include "playhouse/base/result.h"
#include "playhouse/net/serial/serial_line.h"

namespace playhouse::net {

/// Opens a serial port: not blocking, close-on-exec, and of this program alone. Fails for what is no terminal.
Result<int> open_serial_port(const std::string& path, const SerialSettings& settings);

/// Raw bytes, as the settings say.
Result<void> set_terminal(int descriptor, const std::string& name, const SerialSettings& settings);

/// What was set, by whichever program.
SerialSettings settings_of_terminal(int descriptor);

/// A pseudo-terminal, and the name that other programs find it by.
struct PseudoTerminal {
  int descriptor = -1;  // our end; not blocking, close-on-exec
  int other = -1;       // the other end, which stays open here so that programs may open and close it
  std::string link;     // of the file system
  std::string device;   // that it leads to, as "/dev/pts/4"

  /// Removes the link, if it still leads there.
  void remove() const;
};

/// Makes one, found at `link`, in place of a link there that a killed program left, if its terminal is gone.
Result<PseudoTerminal> open_pseudo_terminal(const std::string& link, const SerialSettings& settings);

}  // namespace playhouse::net
