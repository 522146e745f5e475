#include "playhouse/net/local/unix_socket.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace playhouse::net {
namespace {

struct UnixAddress {
  sockaddr_un bytes{};
  std::string path;
};

Result<UnixAddress> address_in(const std::string& folder, std::uint16_t port) {
  UnixAddress address{.bytes = {}, .path = folder + "/" + std::to_string(port)};
  if (address.path.size() >= sizeof address.bytes.sun_path)
    return Error{address.path, "invalid path of a socket: up to " +
                                   std::to_string(sizeof address.bytes.sun_path - 1) + " bytes are valid"};
  address.bytes.sun_family = AF_UNIX;
  std::memcpy(address.bytes.sun_path, address.path.data(), address.path.size());
  return address;
}

Error failure(const std::string& path, const std::string& what, int code) {
  return {path, what + std::generic_category().message(code)};
}

/// Closed unless released.
class Descriptor {
 public:
  Descriptor() : number_(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  int release() {
    const int number = number_;
    number_ = -1;
    return number;
  }

 private:
  int number_;
};

int connect_by(const Descriptor& socket, const UnixAddress& address) {
  return ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address.bytes), sizeof address.bytes);
}

/// 0, or the reason.
int bind_by(const Descriptor& socket, const UnixAddress& address) {
  return ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address.bytes), sizeof address.bytes) == 0
             ? 0
             : errno;
}

/// A socket whose program has ended without removing it. Other files are never removed.
bool is_left_over(const UnixAddress& address) {
  struct stat file {};
  if (::lstat(address.path.c_str(), &file) != 0 || !S_ISSOCK(file.st_mode)) return false;
  const Descriptor probe;
  return connect_by(probe, address) != 0 && errno == ECONNREFUSED;
}

}  // namespace

void UnixListening::remove() const {
  struct stat now {};
  if (::lstat(path.c_str(), &now) == 0 && now.st_ino == file) ::unlink(path.c_str());
}

Result<UnixListening> listen_unix(const std::string& folder, std::uint16_t port) {
  const Result<UnixAddress> address = address_in(folder, port);
  if (!address) return address.error();
  Descriptor socket;
  int fault = bind_by(socket, *address);
  if (fault == EADDRINUSE && is_left_over(*address)) {
    ::unlink(address->path.c_str());
    fault = bind_by(socket, *address);
  }
  if (fault != 0) return failure(address->path, "cannot listen: ", fault);
  struct stat made {};
  if (::lstat(address->path.c_str(), &made) != 0 || ::listen(socket.get(), SOMAXCONN) != 0)
    return failure(address->path, "cannot listen: ", errno);
  return UnixListening{socket.release(), address->path, made.st_ino};
}

Result<int> connect_unix(const std::string& folder, std::uint16_t port) {
  const Result<UnixAddress> address = address_in(folder, port);
  if (!address) return address.error();
  Descriptor socket;
  if (connect_by(socket, *address) != 0) return failure(address->path, "cannot connect: ", errno);
  return socket.release();
}

std::string unix_peer(int descriptor) {
  ucred who{};
  socklen_t size = sizeof who;
  ::getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &who, &size);
  return "unix:" + std::to_string(who.pid);
}

}  // namespace playhouse::net
