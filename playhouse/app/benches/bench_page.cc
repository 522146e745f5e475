#include "playhouse/app/benches/bench_page.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace playhouse::app {
namespace {

constexpr std::string_view kHandshake =
    "GET /live HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
constexpr unsigned kText = 1, kBinary = 2, kClose = 8;  // opcodes
constexpr unsigned kFinal = 0x80, kMasked = 0x80;

Error system_error(std::string_view what) {
  return Error{"", fmt::format("a page: {}: {}", what, std::strerror(errno))};
}

/// A number in network byte order.
std::uint64_t number(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

}  // namespace

PageSocket::PageSocket(PageSocket&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), in_(std::move(other.in_)), taken_(other.taken_) {}

PageSocket::~PageSocket() {
  if (socket_ >= 0) close(socket_);
}

Result<PageSocket> PageSocket::connect(std::uint16_t port) {
  PageSocket page(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(page.socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    return system_error("cannot connect");
  if (const Result<void> sent = page.send(kHandshake); !sent) return sent.error();
  std::size_t end = std::string::npos;
  while ((end = page.in_.find("\r\n\r\n")) == std::string::npos)
    if (const Result<void> read = page.fill(page.in_.size() + 1); !read) return read.error();
  if (!page.in_.starts_with("HTTP/1.1 101 "))
    return Error{"", "a page: the server answers: " + page.in_.substr(0, page.in_.find('\r'))};
  page.taken_ = end + 4;
  return page;
}

Result<void> PageSocket::send_text(std::string_view text) {
  std::string frame = {static_cast<char>(kFinal | kText)};
  if (text.size() < 126) {
    frame += static_cast<char>(kMasked | text.size());
  } else {
    frame += static_cast<char>(kMasked | 126);
    frame += static_cast<char>(text.size() >> 8);
    frame += static_cast<char>(text.size() & 0xFF);
  }
  frame += std::string(4, '\0');  // a mask that leaves the text as it is
  frame += text;
  return send(frame);
}

Result<PageSocket::PageMessage> PageSocket::next() {
  for (;;) {
    in_.erase(0, std::exchange(taken_, 0));
    if (const Result<void> read = fill(2); !read) return read.error();
    const unsigned opcode = static_cast<unsigned char>(in_[0]) & 0xFu;
    std::uint64_t size = static_cast<unsigned char>(in_[1]) & 0x7Fu;
    const std::size_t extended = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (const Result<void> read = fill(2 + extended); !read) return read.error();
    if (extended > 0) size = number(std::string_view(in_).substr(2, extended));
    const std::size_t head = 2 + extended;
    if (const Result<void> read = fill(head + static_cast<std::size_t>(size)); !read) return read.error();
    taken_ = head + static_cast<std::size_t>(size);
    if (opcode == kClose) return Error{"", "a page: the server has closed"};
    if (opcode == kText || opcode == kBinary)
      return PageMessage{opcode == kBinary,
                         std::string_view(in_).substr(head, static_cast<std::size_t>(size))};
  }
}

Result<void> PageSocket::fill(std::size_t count) {
  std::array<char, 65536> buffer;
  while (in_.size() < count) {
    const ssize_t received = recv(socket_, buffer.data(), buffer.size(), 0);
    if (received < 0 && errno == EINTR) continue;
    if (received < 0) return system_error("cannot read");
    if (received == 0) return Error{"", "a page: the server has closed"};
    in_.append(buffer.data(), static_cast<std::size_t>(received));
  }
  return {};
}

Result<void> PageSocket::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return system_error("cannot write");
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return {};
}

}  // namespace playhouse::app
