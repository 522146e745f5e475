#include "fake_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::client {

bool Peer::read_exactly(std::span<std::byte> out) {
  while (!out.empty()) {
    const ssize_t got = recv(fd_, out.data(), out.size(), 0);
    if (got <= 0) return false;
    out = out.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

std::optional<Received> Peer::receive() {
  std::array<std::byte, limits::kHeaderBytes> head;
  if (!read_exactly(head)) return std::nullopt;
  Received message{wire::decode_header(head), {}};
  message.body.resize(message.header.size);
  if (!read_exactly(message.body)) return std::nullopt;
  received.push_back(message);
  return message;
}

void Peer::send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(fd_, bytes.data(), std::min(bytes.size(), piece_), MSG_NOSIGNAL);
    if (sent <= 0) return;  // the client has disconnected
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
}

void Peer::say(wire::Header header, std::span<const std::byte> body) {
  header.size = static_cast<std::uint32_t>(body.size());
  std::array<std::byte, limits::kHeaderBytes> head;
  wire::encode_header(header, head);
  send(head);
  send(body);
}

void Peer::answer(const Received& request, std::span<const std::byte> body, wire::MessageType type) {
  wire::Header header = request.header;
  header.type = type;
  say(header, body);
}

void Peer::position(double x, double timestamp) {
  wire::Header header;
  header.interf = wire::position2d::kCode;
  header.subtype = wire::position2d::kDataState;
  header.timestamp = timestamp;
  wire::position2d::Data data;
  data.pos.px = x;
  say(header, wire::encode(data));
}

void Peer::synch() {
  wire::Header header;
  header.interf = wire::player::kCode;
  header.type = wire::MessageType::kSynch;
  header.subtype = wire::player::kSynchOk;
  say(header, {});
}

void Peer::overflow(std::uint32_t lost) {
  wire::Header header;
  header.interf = wire::player::kCode;
  header.type = wire::MessageType::kSynch;
  header.subtype = wire::player::kSynchOverflow;
  say(header, wire::encode(wire::Uint32{lost}));
}

void Peer::serve(const std::function<void(const Received&)>& rest) {
  while (const auto message = receive()) {
    const bool to_server = message->header.interf == wire::player::kCode;
    if (to_server && message->header.subtype == wire::player::kReqDatamode) {
      answer(*message);
    } else if (to_server && message->header.subtype == wire::player::kReqDev) {
      answer(*message, message->body);
    } else {
      rest(*message);
    }
  }
}

FakeServer::FakeServer(Script script, std::string banner)
    : listener_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof here;
  auto* address = reinterpret_cast<sockaddr*>(&here);
  PLAYHOUSE_ASSERT(bind(listener_, address, size) == 0 && listen(listener_, 1) == 0);
  PLAYHOUSE_ASSERT(getsockname(listener_, address, &size) == 0);
  port_ = ntohs(here.sin_port);
  banner.resize(limits::kBannerBytes);
  thread_ = std::thread([this, script = std::move(script), banner] { run(script, banner); });
}

FakeServer::~FakeServer() {
  finish();
}

void FakeServer::finish() {
  if (thread_.joinable()) thread_.join();
}

void FakeServer::run(const Script& script, std::string banner) {
  const int fd = accept(listener_, nullptr, nullptr);
  close(listener_);
  if (fd < 0) return;
  const int on = 1;
  setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  const timeval patience{10, 0};
  setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  Peer peer(fd);
  peer.send(banner);
  script(peer);
  received_ = std::move(peer.received);
  close(fd);
}

}  // namespace playhouse::client
