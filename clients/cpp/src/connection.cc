#include "connection.h"

#include <array>
#include <string_view>

namespace playhouse::client {

namespace {

/// Consumed bytes at the front of the buffer are compacted beyond this.
constexpr std::size_t kCompactBytes = 65536;

}  // namespace

Result<Connection> Connection::open(const std::string& host, std::uint16_t port, Deadline deadline) {
  const std::string peer = host + ":" + std::to_string(port);
  Result<Socket> socket = Socket::connect(host, port, deadline);
  if (!socket) return Error{peer, "cannot connect: " + socket.error().text};
  Connection made(std::move(*socket), peer, port);
  const Result<bool> come = made.fill(limits::kBannerBytes, deadline);
  if (!come) return come.error();
  if (!*come)
    return Error{peer, "cannot connect: nothing heard from it; it may speak TLS (docs/security.md)"};
  const std::string_view raw(reinterpret_cast<const char*>(made.bytes_.data()), limits::kBannerBytes);
  made.banner_ = raw.substr(0, raw.find('\0'));
  if (!made.banner_.starts_with("Player v.")) return Error{peer, "not a Player server"};
  made.consume(limits::kBannerBytes);
  return made;
}

Result<void> Connection::send(wire::Header header, std::span<const std::byte> body, Deadline deadline) {
  if (!is_open()) return Error{peer_, "the connection is closed"};
  if (body.size() > limits::kBodyBytes) return Error{peer_, "a message over the wire's limit was not sent"};
  header.size = static_cast<std::uint32_t>(body.size());
  std::array<std::byte, limits::kHeaderBytes> head;
  wire::encode_header(header, head);
  std::vector<std::byte> bytes(head.begin(), head.end());
  bytes.insert(bytes.end(), body.begin(), body.end());
  const Result<void> sent = socket_.send(bytes, deadline);
  return sent ? sent : fault(sent.error());
}

Result<std::optional<Message>> Connection::receive(Deadline deadline) {
  const Result<bool> head = fill(limits::kHeaderBytes, deadline);
  if (!head) return head.error();
  if (!*head) return std::optional<Message>();
  const wire::Header header = peek_header();
  if (header.size > limits::kBodyBytes) {
    socket_.close(Clock::now());
    return Error{peer_,
                 "a header announces " + std::to_string(header.size) + " bytes, over the wire's limit"};
  }
  const std::size_t size = limits::kHeaderBytes + header.size;
  const Result<bool> all = fill(size, deadline);
  if (!all) return all.error();
  if (!*all) return std::optional<Message>();
  const auto body = std::span(bytes_).subspan(start_ + limits::kHeaderBytes, header.size);
  Message message{header, {body.begin(), body.end()}};
  consume(size);
  return std::optional(std::move(message));
}

bool Connection::has_message() const {
  if (unread() < limits::kHeaderBytes) return false;
  const std::size_t size = peek_header().size;
  return size > limits::kBodyBytes || unread() >= limits::kHeaderBytes + size;
}

/// Buffers at least `count` bytes; false on timeout.
Result<bool> Connection::fill(std::size_t count, Deadline deadline) {
  std::array<std::byte, 65536> chunk;
  while (unread() < count) {
    if (!is_open()) return Error{peer_, "the connection is closed"};
    const Result<std::size_t> got = socket_.receive(chunk, deadline);
    if (!got) return fault(got.error());
    if (*got == 0) return false;
    bytes_.insert(bytes_.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(*got));
  }
  return true;
}

void Connection::consume(std::size_t count) {
  start_ += count;
  if (unread() == 0 || start_ > kCompactBytes) {
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(start_));
    start_ = 0;
  }
}

wire::Header Connection::peek_header() const {
  return wire::decode_header(std::span(bytes_).subspan(start_).first<limits::kHeaderBytes>());
}

}  // namespace playhouse::client
