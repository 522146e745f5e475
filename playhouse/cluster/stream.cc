#include "playhouse/cluster/stream.h"

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
#include <memory>
#include <system_error>
#include <utility>

#include "playhouse/base/packing.h"

namespace playhouse::cluster {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kHeadBytes = 5;           // size of the body and type
constexpr std::size_t kPieceBytes = 256 << 10;  // read from a socket at once
constexpr int kIdleSeconds = 10;                // before the system asks whether a silent peer still exists

Clock::time_point deadline_after(Seconds patience) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(patience);
}

/// Those of the events that have come, or others that the next system call reports; 0 when the
/// time is over. Without a deadline: waits for ever.
short wait_for(int socket, short events, std::optional<Clock::time_point> deadline) {
  for (;;) {
    int milliseconds = -1;
    if (deadline) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(*deadline - Clock::now()).count();
      milliseconds = static_cast<int>(std::clamp<std::int64_t>(left, 0, INT_MAX));
    }
    pollfd entry{socket, events, 0};
    const int ready = poll(&entry, 1, milliseconds);
    if (ready > 0) return entry.revents;
    if (ready == 0) return 0;
    if (errno != EINTR) return events;
  }
}

/// 0 or errno.
int connect_within(int socket, const addrinfo& address, Clock::time_point deadline) {
  if (::connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (wait_for(socket, POLLOUT, deadline) == 0) return ETIMEDOUT;
  int fault = 0;
  socklen_t size = sizeof fault;
  return getsockopt(socket, SOL_SOCKET, SO_ERROR, &fault, &size) == 0 ? fault : errno;
}

void set(int socket, int level, int option, int value) {
  setsockopt(socket, level, option, &value, sizeof value);
}

}  // namespace

std::string reason(int code) {
  return std::generic_category().message(code);
}

Stream::Stream(int socket, std::size_t limit) : socket_(socket), limit_(limit) {
  if (socket < 0) return;
  fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) | O_NONBLOCK);
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);  // a tick waits for each message
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);  // a machine that has lost its power says nothing
  set(socket, IPPROTO_TCP, TCP_KEEPIDLE, kIdleSeconds);
  set(socket, IPPROTO_TCP, TCP_KEEPINTVL, kIdleSeconds / 2);
  set(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
}

Stream::Stream(Stream&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      limit_(other.limit_),
      in_(std::move(other.in_)),
      begin_(other.begin_),
      out_(std::move(other.out_)),
      sent_(other.sent_) {}

Stream& Stream::operator=(Stream&& other) noexcept {
  std::swap(socket_, other.socket_);
  std::swap(limit_, other.limit_);
  std::swap(in_, other.in_);
  std::swap(begin_, other.begin_);
  std::swap(out_, other.out_);
  std::swap(sent_, other.sent_);
  return *this;
}

Stream::~Stream() {
  close();
}

void Stream::close() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
}

Result<Stream> Stream::connect(const std::string& host, std::uint16_t port, Seconds patience) {
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
    Stream stream(socket, SIZE_MAX);
    fault = socket < 0 ? errno : connect_within(socket, *address, deadline_after(patience));
    if (fault == 0) return stream;
  }
  return Error{"", reason(fault)};
}

std::string Stream::peer() const {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> port{};
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  if (getpeername(socket_, any, &size) != 0 || getnameinfo(any, size, host.data(), host.size(), port.data(),
                                                           port.size(), NI_NUMERICHOST | NI_NUMERICSERV) != 0)
    return "a node";
  const bool is_v6 = address.ss_family == AF_INET6;
  return fmt::format("{}{}{}:{}", is_v6 ? "[" : "", host.data(), is_v6 ? "]" : "", port.data());
}

void Stream::queue(Type type, std::span<const std::byte> body) {
  Packer head(out_);
  head.u32(static_cast<std::uint32_t>(body.size()));
  head.u8(static_cast<std::uint8_t>(type));
  out_.insert(out_.end(), body.begin(), body.end());
}

Result<bool> Stream::flush() {
  while (sent_ < out_.size()) {
    const ssize_t sent = ::send(socket_, out_.data() + sent_, out_.size() - sent_, MSG_NOSIGNAL);
    if (sent >= 0) {
      sent_ += static_cast<std::size_t>(sent);
    } else if (errno == EAGAIN) {
      return false;
    } else if (errno != EINTR) {
      return Error{"", reason(errno)};
    }
  }
  out_ = {};
  sent_ = 0;
  return true;
}

Result<void> Stream::send(Type type, std::span<const std::span<const std::byte>> body, Seconds patience) {
  std::size_t size = 0;
  for (const std::span<const std::byte> piece : body) size += piece.size();
  if (size > UINT32_MAX) return Error{"", "a message is larger than 4 GiB"};
  Bytes head;
  Packer(head).u32(static_cast<std::uint32_t>(size));
  Packer(head).u8(static_cast<std::uint8_t>(type));
  std::vector<iovec> pieces;
  if (sent_ < out_.size()) pieces.push_back({out_.data() + sent_, out_.size() - sent_});
  pieces.push_back({head.data(), head.size()});
  for (const std::span<const std::byte> piece : body)
    if (!piece.empty()) pieces.push_back({const_cast<std::byte*>(piece.data()), piece.size()});
  Clock::time_point deadline = deadline_after(patience);
  for (std::size_t first = 0; first < pieces.size();) {
    msghdr message{};
    message.msg_iov = pieces.data() + first;
    message.msg_iovlen = std::min<std::size_t>(pieces.size() - first, IOV_MAX);
    const ssize_t sent = sendmsg(socket_, &message, MSG_NOSIGNAL);
    if (sent < 0) {
      if (errno == EINTR) continue;
      if (errno != EAGAIN) return Error{"", reason(errno)};
      // Receives meanwhile: the peer may wait for that before it reads.
      const auto wanted = static_cast<short>(has_room() ? POLLIN | POLLOUT : POLLOUT);
      const short events = wait_for(socket_, wanted, deadline);
      if (events == 0) return Error{"", fmt::format("takes nothing for {:g} s", patience.count())};
      if ((events & POLLIN) != 0)
        if (const Result<void> received = receive(); !received) return received;
      continue;
    }
    deadline = deadline_after(patience);
    auto left = static_cast<std::size_t>(sent);
    while (first < pieces.size() && left >= pieces[first].iov_len) left -= pieces[first++].iov_len;
    if (first == pieces.size()) break;
    pieces[first].iov_base = static_cast<std::byte*>(pieces[first].iov_base) + left;
    pieces[first].iov_len -= left;
  }
  out_ = {};
  sent_ = 0;
  return {};
}

Result<void> Stream::receive() {
  in_.erase(in_.begin(), in_.begin() + static_cast<std::ptrdiff_t>(begin_));
  begin_ = 0;
  for (;;) {
    const std::size_t before = in_.size();
    in_.resize(before + kPieceBytes);
    const ssize_t got = recv(socket_, in_.data() + before, kPieceBytes, 0);
    const int fault = errno;
    in_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0) return Error{"", "closed the connection"};
    if (got < 0) {
      if (fault == EINTR) continue;
      if (fault == EAGAIN) return {};
      return Error{"", reason(fault)};
    }
    if (static_cast<std::size_t>(got) < kPieceBytes) return {};
    if (!has_room()) return {};  // next() looks at it first
  }
}

Result<std::optional<Message>> Stream::next() {
  const std::span<const std::byte> bytes = std::span(in_).subspan(begin_);
  if (bytes.size() < kHeadBytes) return std::optional<Message>();
  Unpacker head(bytes);
  const std::uint32_t size = head.u32();
  const std::uint8_t type = head.u8();
  if (size > limit_) return Error{"", fmt::format("sent a message of {} bytes, {} at most", size, limit_)};
  if (type < static_cast<std::uint8_t>(Type::kHello) || type > static_cast<std::uint8_t>(Type::kEnd))
    return Error{"", "does not speak the protocol of clusters"};
  if (bytes.size() - kHeadBytes < size) return std::optional<Message>();
  begin_ += kHeadBytes + size;
  return std::optional<Message>({static_cast<Type>(type), bytes.subspan(kHeadBytes, size)});
}

Result<Message> Stream::wait(std::optional<Seconds> patience) {
  std::optional<Clock::time_point> deadline;
  if (patience) deadline = deadline_after(*patience);
  Result<void> received;
  for (;;) {
    const Result<std::optional<Message>> message = next();
    if (!message) return message.error();
    if (*message) return **message;
    if (!received) return received.error();
    if (!wait_for(socket_, POLLIN, deadline))
      return Error{"", fmt::format("is silent for {:g} s", patience->count())};
    received = receive();
  }
}

}  // namespace playhouse::cluster
