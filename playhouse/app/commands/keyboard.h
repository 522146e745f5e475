#pragma once

/// Unbuffered keys from a terminal, without Enter. Terminal settings are restored on
/// destruction. Ctrl-C remains a signal; job control and flow control keys are ordinary keys.

#include <termios.h>

#include <cstdint>
#include <optional>

namespace playhouse::app {

enum class Key : std::uint8_t { kForward, kBackward, kLeft, kRight, kStop, kFaster, kSlower, kQuit, kOther };

class Keyboard {
 public:
  /// Reads standard input; anything but a terminal (a pipe) is read unchanged.
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  /// Waits for a key; none on timeout. End of input is kQuit.
  std::optional<Key> wait(int milliseconds);

 private:
  std::optional<termios> before_;  // none: not a terminal
};

/// Key bindings: arrows or w a s d (i j k l), space stops, + and - change the speed,
/// q, Ctrl-D, Ctrl-Z or Ctrl-backslash quit. `rest` follows an escape character.
Key key_of(char first, const char* rest);

}  // namespace playhouse::app
