#pragma once

/// Keys from a terminal, one at a time, without Enter. The terminal is as it was when this goes. Ctrl-C stays
/// a signal; keys that would stop the program or its output behind its back are keys like others.

#include <termios.h>

#include <cstdint>
#include <optional>

namespace playhouse::app {

enum class Key : std::uint8_t { kForward, kBackward, kLeft, kRight, kStop, kFaster, kSlower, kQuit, kOther };

class Keyboard {
 public:
  /// Reads standard input; what is no terminal (a pipe) is read as it is.
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  /// Waits for a key; none in time. The end of the input is kQuit.
  std::optional<Key> wait(int milliseconds);

 private:
  std::optional<termios> before_;  // none: no terminal
};

/// Keys as programs know them: arrows or w a s d (i j k l), space stops, + and - change the speed, q,
/// Ctrl-D, Ctrl-Z or Ctrl-backslash ends. `rest` is what follows an escape character.
Key key_of(char first, const char* rest);

}  // namespace playhouse::app
