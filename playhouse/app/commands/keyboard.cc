#include "playhouse/app/commands/keyboard.h"

#include <poll.h>
#include <unistd.h>

#include <cctype>
#include <string_view>

namespace playhouse::app {
namespace {

bool readable(int milliseconds) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, milliseconds) == 1;
}

Key arrow(std::string_view rest) {
  if (rest == "[A" || rest == "OA") return Key::kForward;
  if (rest == "[B" || rest == "OB") return Key::kBackward;
  if (rest == "[C" || rest == "OC") return Key::kRight;
  if (rest == "[D" || rest == "OD") return Key::kLeft;
  return Key::kOther;
}

}  // namespace

Keyboard::Keyboard() {
  termios now{};
  if (tcgetattr(STDIN_FILENO, &now) != 0) return;
  before_ = now;
  now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  now.c_iflag &= ~static_cast<tcflag_t>(IXON);  // disables Ctrl-S, which would block output and keys
  // Disables Ctrl-Z and Ctrl-backslash, which would leave the robot driving.
  now.c_cc[VSUSP] = now.c_cc[VQUIT] = _POSIX_VDISABLE;
  now.c_cc[VMIN] = 1;
  now.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &now);
}

Keyboard::~Keyboard() {
  if (before_) tcsetattr(STDIN_FILENO, TCSANOW, &*before_);
}

std::optional<Key> Keyboard::wait(int milliseconds) {
  if (!readable(milliseconds)) return std::nullopt;
  char first = 0;
  if (read(STDIN_FILENO, &first, 1) != 1) return Key::kQuit;
  char rest[3] = {};
  constexpr int kEscape = 27;
  // An arrow key sends three bytes at once; a lone escape nothing more.
  if (first == kEscape && readable(0) && read(STDIN_FILENO, rest, 2) < 0) return Key::kOther;
  return key_of(first, rest);
}

Key key_of(char first, const char* rest) {
  constexpr char kEscape = 27, kEndOfInput = 4, kSuspend = 26,
                 kAbandon = 28;  // Ctrl-D, Ctrl-Z, Ctrl-backslash
  switch (static_cast<char>(std::tolower(static_cast<unsigned char>(first)))) {
    case kEscape:
      return arrow(rest);
    case 'w':
    case 'i':
      return Key::kForward;
    case 's':
    case 'k':
      return Key::kBackward;
    case 'a':
    case 'j':
      return Key::kLeft;
    case 'd':
    case 'l':
      return Key::kRight;
    case ' ':
      return Key::kStop;
    case '+':
    case '=':
      return Key::kFaster;
    case '-':
      return Key::kSlower;
    case 'q':
    case kEndOfInput:
    case kSuspend:
    case kAbandon:
      return Key::kQuit;
    default:
      return Key::kOther;
  }
}

}  // namespace playhouse::app
