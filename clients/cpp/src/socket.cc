#include "socket.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <memory>
#include <system_error>
#include <utility>

namespace playhouse::client {

namespace {

std::string reason(int code) {
  return std::generic_category().message(code);
}

/// Polls for `events`; false on timeout. A deadline in the past still polls once.
bool wait_for(int fd, short events, Deadline deadline) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd entry{fd, events, 0};
    const int ready = poll(&entry, 1, static_cast<int>(std::clamp<std::int64_t>(left, 0, INT_MAX)));
    if (ready > 0) return true;
    if (ready == 0) return false;
    if (errno != EINTR) return true;  // the next system call reports the error
  }
}

/// Connects with a deadline; returns 0 or errno.
int connect_within(int fd, const addrinfo& address, Deadline deadline) {
  if (::connect(fd, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (!wait_for(fd, POLLOUT, deadline)) return ETIMEDOUT;
  int fault = 0;
  socklen_t size = sizeof fault;
  return getsockopt(fd, SOL_SOCKET, SO_ERROR, &fault, &size) == 0 ? fault : errno;
}

}  // namespace

Deadline deadline_after(Seconds patience) {
  constexpr Seconds kYear{365.0 * 86400.0};
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::clamp(patience, Seconds{0.0}, kYear));
}

Result<Socket> Socket::connect_unix(const std::string& path) {
  sockaddr_un address{};
  if (path.size() >= sizeof address.sun_path) return Error{"", "the path is too long"};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, path.size());
  Socket made(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!made.is_open() ||
      ::connect(made.fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    return Error{"", reason(errno)};
  return made;
}

Result<Socket> Socket::connect(const std::string& host, std::uint16_t port, Deadline deadline) {
  if (host.starts_with('/')) return connect_unix(host + "/" + std::to_string(port));
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int fault = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found); fault != 0) {
    return Error{"", gai_strerror(fault)};
  }
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses(found, freeaddrinfo);
  int fault = EADDRNOTAVAIL;
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
    Socket made(socket(address->ai_family, address->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                       address->ai_protocol));
    fault = made.is_open() ? connect_within(made.fd_, *address, deadline) : errno;
    if (fault != 0) continue;
    const int on = 1;
    setsockopt(made.fd_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return made;
  }
  return Error{"", reason(fault)};
}

Socket::Socket(Socket&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Socket& Socket::operator=(Socket&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

Socket::~Socket() {
  drop();
}

Result<void> Socket::send(std::span<const std::byte> bytes, Deadline deadline) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
    } else if (errno == EAGAIN) {
      if (wait_for(fd_, POLLOUT, deadline)) continue;
      drop();
      return Error{"", "the server takes nothing any more"};
    } else if (errno != EINTR) {
      const int fault = errno;
      drop();
      return Error{"", "the server is gone: " + reason(fault)};
    }
  }
  return {};
}

Result<std::size_t> Socket::receive(std::span<std::byte> out, Deadline deadline) {
  for (;;) {
    const ssize_t got = recv(fd_, out.data(), out.size(), 0);
    if (got > 0) return static_cast<std::size_t>(got);
    if (got == 0) {
      drop();
      return Error{"", "the run ended: the server closed the connection"};
    }
    if (errno == EAGAIN) {
      if (!wait_for(fd_, POLLIN, deadline)) return std::size_t{0};
    } else if (errno != EINTR) {
      const int fault = errno;
      drop();
      return Error{"", "the server is gone: " + reason(fault)};
    }
  }
}

void Socket::close(Deadline deadline) {
  if (!is_open()) return;
  shutdown(fd_, SHUT_WR);
  std::array<std::byte, 65536> rest;
  while (Clock::now() < deadline) {
    const Result<std::size_t> got = receive(rest, deadline);
    if (!got || *got == 0) break;
  }
  drop();
}

void Socket::drop() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

}  // namespace playhouse::client
