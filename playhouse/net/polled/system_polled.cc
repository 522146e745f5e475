#include "playhouse/net/polled/system_polled.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "playhouse/base/monotonic.h"

namespace playhouse::net {
namespace {

constexpr int kIdleSeconds = 10;  // before the system asks whether a silent peer still exists

/// What the system says of an errno.
std::string reason(int code) {
  return std::generic_category().message(code);
}

void set(int socket, int level, int option, int value) {
  setsockopt(socket, level, option, &value, sizeof value);
}

int milliseconds_until(double time) {
  return static_cast<int>(std::clamp(std::ceil((time - monotonic_seconds()) * 1000), 0.0, double{INT_MAX}));
}

std::string peer_of(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> port{};
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  if (getpeername(socket, any, &size) != 0 || getnameinfo(any, size, host.data(), host.size(), port.data(),
                                                          port.size(), NI_NUMERICHOST | NI_NUMERICSERV) != 0)
    return "a node";
  const bool is_v6 = address.ss_family == AF_INET6;
  return fmt::format("{}{}{}:{}", is_v6 ? "[" : "", host.data(), is_v6 ? "]" : "", port.data());
}

class SystemPolledStream final : public PolledStream {
 public:
  explicit SystemPolledStream(int socket) : socket_(socket), peer_(peer_of(socket)) {
    fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) | O_NONBLOCK);
    set(socket, IPPROTO_TCP, TCP_NODELAY, 1);  // a tick waits for each message
    set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);  // a machine that has lost its power says nothing
    set(socket, IPPROTO_TCP, TCP_KEEPIDLE, kIdleSeconds);
    set(socket, IPPROTO_TCP, TCP_KEEPINTVL, kIdleSeconds / 2);
    set(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
  }
  ~SystemPolledStream() override { ::close(socket_); }
  SystemPolledStream(const SystemPolledStream&) = delete;
  SystemPolledStream& operator=(const SystemPolledStream&) = delete;

  int socket() const { return socket_; }
  const std::string& peer() const override { return peer_; }

  Result<std::size_t> send(std::span<const std::span<const std::byte>> parts) override {
    pieces_.clear();
    for (const std::span<const std::byte> part : parts.first(std::min<std::size_t>(parts.size(), IOV_MAX)))
      pieces_.push_back({const_cast<std::byte*>(part.data()), part.size()});
    msghdr message{};
    message.msg_iov = pieces_.data();
    message.msg_iovlen = pieces_.size();
    for (;;) {
      const ssize_t sent = sendmsg(socket_, &message, MSG_NOSIGNAL);
      if (sent >= 0) return static_cast<std::size_t>(sent);
      if (errno == EAGAIN) return std::size_t{0};
      if (errno != EINTR) return Error{"", reason(errno)};
    }
  }

  Result<std::size_t> receive(std::span<std::byte> out) override {
    for (;;) {
      const ssize_t got = recv(socket_, out.data(), out.size(), 0);
      if (got > 0) return static_cast<std::size_t>(got);
      if (got == 0) return Error{"", "closed the connection"};
      if (errno == EAGAIN) return std::size_t{0};
      if (errno != EINTR) return Error{"", reason(errno)};
    }
  }

 private:
  const int socket_;
  const std::string peer_;
  std::vector<iovec> pieces_;  // scratch
};

class SystemPolledListener final : public PolledListener {
 public:
  SystemPolledListener(int socket, std::uint16_t port) : socket_(socket), port_(port) {}
  ~SystemPolledListener() override { ::close(socket_); }
  SystemPolledListener(const SystemPolledListener&) = delete;
  SystemPolledListener& operator=(const SystemPolledListener&) = delete;

  int socket() const { return socket_; }
  std::uint16_t port() const override { return port_; }
  std::unique_ptr<PolledStream> accept() override {
    const int socket = accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
    return socket < 0 ? nullptr : std::make_unique<SystemPolledStream>(socket);
  }

 private:
  const int socket_;
  const std::uint16_t port_;
};

/// 0 or errno.
int connect_within(int socket, const addrinfo& address, double until) {
  if (::connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  pollfd entry{socket, POLLOUT, 0};
  int ready = 0;
  while ((ready = poll(&entry, 1, milliseconds_until(until))) < 0 && errno == EINTR) {
  }
  if (ready == 0) return ETIMEDOUT;
  int fault = 0;
  socklen_t size = sizeof fault;
  return getsockopt(socket, SOL_SOCKET, SO_ERROR, &fault, &size) == 0 ? fault : errno;
}

class SystemPolledNetwork final : public PolledNetwork {
 public:
  double now() const override { return monotonic_seconds(); }

  bool wait(std::span<const PollWish> wishes, PolledListener* listener, double until) override {
    std::vector<pollfd> entries;
    for (const PollWish& wish : wishes) {
      const auto events = static_cast<short>((wish.reads ? POLLIN : 0) | (wish.writes ? POLLOUT : 0));
      entries.push_back({static_cast<SystemPolledStream&>(*wish.stream).socket(), events, 0});
    }
    if (listener != nullptr)
      entries.push_back({static_cast<SystemPolledListener&>(*listener).socket(), POLLIN, 0});
    const int time = std::isinf(until) ? -1 : milliseconds_until(until);
    return poll(entries.data(), entries.size(), time) != 0;  // interrupted: too early
  }

  Result<std::unique_ptr<PolledStream>> connect(const std::string& host, std::uint16_t port,
                                                double seconds) override {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (const int fault = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found); fault != 0)
      return Error{"", gai_strerror(fault)};
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses(found, freeaddrinfo);
    int fault = EADDRNOTAVAIL;
    for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
      const int socket = ::socket(address->ai_family, address->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                                  address->ai_protocol);
      fault = socket < 0 ? errno : connect_within(socket, *address, now() + seconds);
      if (fault == 0) return polled_stream_of(socket);
      if (socket >= 0) ::close(socket);
    }
    return Error{"", reason(fault)};
  }

  Result<std::unique_ptr<PolledListener>> listen(const std::string& bind, std::uint16_t port) override {
    sockaddr_storage address{};
    auto* const v4 = reinterpret_cast<sockaddr_in*>(&address);
    auto* const v6 = reinterpret_cast<sockaddr_in6*>(&address);
    const bool is_v6 = inet_pton(AF_INET6, bind.c_str(), &v6->sin6_addr) == 1;
    if (!is_v6 && inet_pton(AF_INET, bind.c_str(), &v4->sin_addr) != 1)
      return Error{"", reason(EADDRNOTAVAIL)};
    address.ss_family = is_v6 ? AF_INET6 : AF_INET;
    (is_v6 ? v6->sin6_port : v4->sin_port) = htons(port);
    const int socket = ::socket(address.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (socket < 0) return Error{"", reason(errno)};
    set(socket, SOL_SOCKET, SO_REUSEADDR, 1);
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = is_v6 ? sizeof *v6 : sizeof *v4;
    if (::bind(socket, any, size) == 0 && ::listen(socket, SOMAXCONN) == 0 &&
        getsockname(socket, any, &size) == 0)
      return std::unique_ptr<PolledListener>(
          std::make_unique<SystemPolledListener>(socket, ntohs(is_v6 ? v6->sin6_port : v4->sin_port)));
    const int fault = errno;
    ::close(socket);
    return Error{"", reason(fault)};
  }
};

}  // namespace

PolledNetwork& system_polled() {
  static SystemPolledNetwork network;
  return network;
}

std::unique_ptr<PolledStream> polled_stream_of(int socket) {
  return std::make_unique<SystemPolledStream>(socket);
}

}  // namespace playhouse::net
