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

#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"

namespace playhouse::cluster {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kHeadBytes = 5;           // size of the body and type
constexpr std::size_t kPieceBytes = 256 << 10;  // read from a socket at once
constexpr int kIdleSeconds = 10;                // before the system asks whether a silent peer still exists
constexpr std::int64_t kLookMilliseconds = 50;  // between looks at Until::stopped
constexpr Seconds kRestOfMessage{30};           // for what has begun

/// Those of the events that have come, or others that the next system call reports; 0 when the
/// time is over. Without an end: waits for ever.
short wait_for(int socket, short events, const std::optional<Until>& until) {
  for (;;) {
    int milliseconds = -1;
    bool is_last = !until;
    if (until) {
      const std::int64_t left =
          std::chrono::ceil<std::chrono::milliseconds>(until->deadline - Clock::now()).count();
      const std::int64_t most = until->stopped != nullptr ? kLookMilliseconds : INT_MAX;
      is_last = left <= most;
      milliseconds = static_cast<int>(std::clamp<std::int64_t>(left, 0, most));
    }
    pollfd entry{socket, events, 0};
    const int ready = poll(&entry, 1, milliseconds);
    if (ready > 0) return entry.revents;
    if (ready < 0 && errno != EINTR) return events;
    if (ready == 0 && is_last) return 0;
    if (until && until->stopped != nullptr && *until->stopped) return 0;
  }
}

/// 0 or errno.
int connect_within(int socket, const addrinfo& address, const Until& end) {
  if (::connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (wait_for(socket, POLLOUT, end) == 0) return ETIMEDOUT;
  int fault = 0;
  socklen_t size = sizeof fault;
  return getsockopt(socket, SOL_SOCKET, SO_ERROR, &fault, &size) == 0 ? fault : errno;
}

void set(int socket, int level, int option, int value) {
  setsockopt(socket, level, option, &value, sizeof value);
}

}  // namespace

Until until(Seconds patience, std::size_t bytes, const std::atomic<bool>* stopped) {
  const Seconds all = patience + Seconds{static_cast<double>(bytes) / limits::kClusterBytesPerSecond};
  return {Clock::now() + std::chrono::duration_cast<Clock::duration>(all), stopped};
}

std::string reason(int code) {
  return std::generic_category().message(code);
}

MessageStream::MessageStream(int socket, std::size_t limit) : socket_(socket), limit_(limit) {
  if (socket < 0) return;
  fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) | O_NONBLOCK);
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);  // a tick waits for each message
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);  // a machine that has lost its power says nothing
  set(socket, IPPROTO_TCP, TCP_KEEPIDLE, kIdleSeconds);
  set(socket, IPPROTO_TCP, TCP_KEEPINTVL, kIdleSeconds / 2);
  set(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
}

MessageStream::MessageStream(MessageStream&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      limit_(other.limit_),
      in_(std::move(other.in_)),
      begin_(other.begin_),
      queued_(std::move(other.queued_)),
      sent_(other.sent_) {}

MessageStream& MessageStream::operator=(MessageStream&& other) noexcept {
  std::swap(socket_, other.socket_);
  std::swap(limit_, other.limit_);
  std::swap(in_, other.in_);
  std::swap(begin_, other.begin_);
  std::swap(queued_, other.queued_);
  std::swap(sent_, other.sent_);
  return *this;
}

MessageStream::~MessageStream() {
  close();
}

void MessageStream::close() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
}

Result<MessageStream> MessageStream::connect(const std::string& host, std::uint16_t port, Seconds patience) {
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
    MessageStream stream(socket, SIZE_MAX);
    fault = socket < 0 ? errno : connect_within(socket, *address, until(patience));
    if (fault == 0) return stream;
  }
  return Error{"", reason(fault)};
}

std::string MessageStream::peer() const {
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

void MessageStream::queue(NodeMessageType type, std::shared_ptr<const Bytes> body) {
  Bytes head;
  Packer(head).u32(static_cast<std::uint32_t>(body->size()));
  Packer(head).u8(static_cast<std::uint8_t>(type));
  queued_.push_back(std::make_shared<const Bytes>(std::move(head)));
  if (!body->empty()) queued_.push_back(std::move(body));
}

Result<std::size_t> MessageStream::flush(std::size_t most) {
  std::size_t all = 0;
  while (!queued_.empty() && all < most) {
    const std::span<const std::byte> left = std::span(*queued_.front()).subspan(sent_);
    const ssize_t sent = ::send(socket_, left.data(), std::min(left.size(), most - all), MSG_NOSIGNAL);
    if (sent < 0 && errno == EAGAIN) break;
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return Error{"", reason(errno)};
    all += static_cast<std::size_t>(sent);
    sent_ += static_cast<std::size_t>(sent);
    if (sent_ < queued_.front()->size()) continue;
    queued_.pop_front();
    sent_ = 0;
  }
  return all;
}

Result<void> MessageStream::send(NodeMessageType type, std::initializer_list<std::span<const std::byte>> body,
                                 Seconds patience) {
  std::size_t size = 0;
  for (const std::span<const std::byte> piece : body) size += piece.size();
  return send(type, std::span(body), until(patience, size));
}

Result<void> MessageStream::send(NodeMessageType type, std::span<const std::span<const std::byte>> body,
                                 Until until) {
  std::size_t size = 0;
  for (const std::span<const std::byte> piece : body) size += piece.size();
  if (size > UINT32_MAX) return Error{"", "a message is larger than 4 GiB"};
  Bytes head;
  Packer(head).u32(static_cast<std::uint32_t>(size));
  Packer(head).u8(static_cast<std::uint8_t>(type));
  std::vector<iovec> pieces;
  const auto add = [&pieces](std::span<const std::byte> piece) {
    if (!piece.empty()) pieces.push_back({const_cast<std::byte*>(piece.data()), piece.size()});
  };
  for (const auto& queued : queued_) add(std::span(*queued).subspan(queued == queued_.front() ? sent_ : 0));
  add(head);
  for (const std::span<const std::byte> piece : body) add(piece);
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
      const short events = Clock::now() < until.deadline ? wait_for(socket_, wanted, until) : short{0};
      if (events == 0) return Error{"", fmt::format("has not taken {} bytes in time", size)};
      if ((events & POLLIN) != 0)
        if (const Result<void> received = receive(); !received) return received;
      continue;
    }
    auto left = static_cast<std::size_t>(sent);
    while (first < pieces.size() && left >= pieces[first].iov_len) left -= pieces[first++].iov_len;
    if (first == pieces.size()) break;
    pieces[first].iov_base = static_cast<std::byte*>(pieces[first].iov_base) + left;
    pieces[first].iov_len -= left;
  }
  queued_.clear();
  sent_ = 0;
  return {};
}

Result<void> MessageStream::receive() {
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

Result<std::optional<NodeMessage>> MessageStream::next() {
  const std::span<const std::byte> bytes = std::span(in_).subspan(begin_);
  if (bytes.size() < kHeadBytes) return std::optional<NodeMessage>();
  Unpacker head(bytes);
  const std::uint32_t size = head.u32();
  const std::uint8_t type = head.u8();
  if (size > limit_) return Error{"", fmt::format("sent a message of {} bytes, {} at most", size, limit_)};
  if (type < static_cast<std::uint8_t>(NodeMessageType::kHello) ||
      type > static_cast<std::uint8_t>(NodeMessageType::kEnd))
    return Error{"", "does not speak the protocol of clusters"};
  if (bytes.size() - kHeadBytes < size) return std::optional<NodeMessage>();
  begin_ += kHeadBytes + size;
  return std::optional<NodeMessage>({static_cast<NodeMessageType>(type), bytes.subspan(kHeadBytes, size)});
}

Result<NodeMessage> MessageStream::wait(std::optional<Seconds> patience) {
  std::optional<Until> end;
  if (patience) end = until(*patience);
  std::optional<Clock::time_point> began;
  Result<void> received;
  for (;;) {
    const Result<std::optional<NodeMessage>> message = next();
    if (!message) return message.error();
    if (*message) return **message;
    if (!received) return received.error();
    if (in_.size() > begin_) {
      if (!began) began = Clock::now();
      end = until(kRestOfMessage, announced());
      end->deadline -= Clock::now() - *began;
    }
    if (end && Clock::now() >= end->deadline) break;
    if (!wait_for(socket_, POLLIN, end)) break;
    received = receive();
  }
  return Error{"",
               began ? "sends a message too slowly" : fmt::format("is silent for {:g} s", patience->count())};
}

/// Bytes of the message that has begun, if its head has come.
std::size_t MessageStream::announced() const {
  const std::span<const std::byte> bytes = std::span(in_).subspan(begin_);
  return bytes.size() < kHeadBytes ? 0 : Unpacker(bytes).u32();
}

}  // namespace playhouse::cluster
