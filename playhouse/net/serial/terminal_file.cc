#include "playhouse/net/serial/terminal_file.h"

// Not <termios.h>, whose struct has no room for any speed: the kernel's.
#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace playhouse::net {
namespace {

#if defined(TCGETS2)
using Termios = termios2;
constexpr auto kGetTermios = TCGETS2, kSetTermios = TCSETS2;
#else  // as on PowerPC, where the first one has speeds of its own
using Termios = termios;
constexpr auto kGetTermios = TCGETS, kSetTermios = TCSETS;
#endif

constexpr std::string_view kTerminals = "/dev/pts/";

Error system_error(const std::string& name, const char* what) {
  return Error{name, fmt::format("{}: {}", what, std::strerror(errno))};
}

/// Closes unless it is given away.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

tcflag_t flags_of(const SerialSettings& settings) {
  tcflag_t flags = CS8 | CREAD | CLOCAL | BOTHER;
  if (settings.parity != SerialParity::kNone) flags |= PARENB;
  if (settings.parity == SerialParity::kOdd) flags |= PARODD;
  if (settings.stop_bits == 2) flags |= CSTOPB;
  return flags;
}

}  // namespace

Result<int> open_serial_port(const std::string& path, const SerialSettings& settings) {
  Descriptor opened(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (opened.get() < 0) return system_error(path, "cannot be opened");
  if (isatty(opened.get()) == 0) return Error{path, "is no serial port"};
  if (flock(opened.get(), LOCK_EX | LOCK_NB) != 0) return Error{path, "is in use by another program"};
  if (const Result<void> set = set_terminal(opened.get(), path, settings); !set) return set.error();
  ioctl(opened.get(), TCFLSH, TCIOFLUSH);
  return opened.release();
}

Result<void> set_terminal(int descriptor, const std::string& name, const SerialSettings& settings) {
  Termios termios{};
  if (ioctl(descriptor, kGetTermios, &termios) != 0) return system_error(name, "has no settings of a line");
  termios.c_iflag = 0;
  termios.c_oflag = 0;
  termios.c_lflag = 0;
  termios.c_cflag = flags_of(settings);
  termios.c_cc[VMIN] = 1;
  termios.c_cc[VTIME] = 0;
  termios.c_ispeed = termios.c_ospeed = static_cast<speed_t>(settings.baud);
  if (ioctl(descriptor, kSetTermios, &termios) == 0) return {};
  return system_error(name, fmt::format("does not take {} baud", settings.baud).c_str());
}

SerialSettings settings_of_terminal(int descriptor) {
  Termios termios{};
  SerialSettings settings;
  if (ioctl(descriptor, kGetTermios, &termios) != 0) return settings;
  settings.baud = static_cast<int>(termios.c_ospeed);
  if ((termios.c_cflag & PARENB) != 0)
    settings.parity = (termios.c_cflag & PARODD) != 0 ? SerialParity::kOdd : SerialParity::kEven;
  settings.stop_bits = (termios.c_cflag & CSTOPB) != 0 ? 2 : 1;
  return settings;
}

void PseudoTerminal::remove() const {
  std::error_code error;
  if (std::filesystem::read_symlink(link, error) == device) std::filesystem::remove(link, error);
}

Result<PseudoTerminal> open_pseudo_terminal(const std::string& link, const SerialSettings& settings) {
  Descriptor own(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  char name[64];
  if (own.get() < 0 || grantpt(own.get()) != 0 || unlockpt(own.get()) != 0 ||
      ptsname_r(own.get(), name, sizeof name) != 0 || fcntl(own.get(), F_SETFL, O_NONBLOCK) != 0)
    return system_error(link, "no pseudo-terminal");
  Descriptor other(::open(name, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (other.get() < 0) return system_error(name, "cannot be opened");
  if (const Result<void> set = set_terminal(other.get(), name, settings); !set) return set.error();
  std::error_code error;
  if (std::filesystem::is_symlink(link, error) && !std::filesystem::exists(link, error) &&
      std::filesystem::read_symlink(link, error).string().starts_with(kTerminals))
    std::filesystem::remove(link, error);
  std::filesystem::create_symlink(name, link, error);
  if (error) return Error{link, "cannot be made: " + error.message()};
  return PseudoTerminal{own.release(), other.release(), link, name};
}

}  // namespace playhouse::net
