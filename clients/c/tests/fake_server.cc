#include "fake_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace playhouse_c {

namespace {

void insist(bool fact, const char *what) {
  if (fact) return;
  std::perror(what);
  std::abort();
}

}  // namespace

Bytes encoded(const ph_struct_type &type, const void *value) {
  ph_buffer out = {nullptr, 0, 0};
  ph_error error;
  insist(ph_encode(&type, value, &out, &error) == PH_OK, "the test encodes what cannot be");
  const Bytes bytes(out.bytes, out.bytes + out.size);
  ph_buffer_free(&out);
  return bytes;
}

bool Peer::read_exactly(std::uint8_t *out, std::size_t size) {
  while (size > 0) {
    const ssize_t got = recv(fd_, out, size, 0);
    if (got <= 0) return false;
    out += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

std::optional<Received> Peer::receive() {
  std::uint8_t head[PH_HEADER_BYTES];
  if (!read_exactly(head, sizeof head)) return std::nullopt;
  Received message{ph_header_decode(head), {}};
  message.body.resize(message.header.size);
  if (!read_exactly(message.body.data(), message.body.size())) return std::nullopt;
  received.push_back(message);
  return message;
}

void Peer::send(const Bytes &bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t sent = ::send(fd_, bytes.data() + at, std::min(bytes.size() - at, piece_), MSG_NOSIGNAL);
    if (sent <= 0) return;  // the client has disconnected
    at += static_cast<std::size_t>(sent);
  }
}

void Peer::say(ph_header header, const Bytes &body) {
  header.size = static_cast<std::uint32_t>(body.size());
  Bytes bytes(PH_HEADER_BYTES);
  ph_header_encode(&header, bytes.data());
  bytes.insert(bytes.end(), body.begin(), body.end());
  send(bytes);
}

void Peer::answer(const Received &request, const Bytes &body, ph_kind kind) {
  ph_header header = request.header;
  header.kind = static_cast<std::uint8_t>(kind);
  header.robot = port_;
  say(header, body);
}

void Peer::data(const ph_message_type *message, const Bytes &body, std::uint16_t index, double timestamp) {
  ph_header header{};
  header.interface_code = message->interface_code;
  header.index = index;
  header.kind = PH_KIND_DATA;
  header.subtype = message->subtype;
  header.timestamp = timestamp;
  say(header, body);
}

void Peer::position(double x, double timestamp) {
  ph_position2d_data state{};
  state.pos.px = x;
  data(PH_POSITION2D_DATA_STATE, playhouse_c::body(ph_position2d_data_type, state), 0, timestamp);
}

void Peer::synch() {
  ph_header header{};
  header.interface_code = PH_PLAYER_CODE;
  header.kind = PH_KIND_SYNCH;
  header.subtype = PH_PLAYER_SYNCH_OK->subtype;
  say(header, {});
}

void Peer::overflow(std::uint32_t lost) {
  ph_header header{};
  header.interface_code = PH_PLAYER_CODE;
  header.kind = PH_KIND_SYNCH;
  header.subtype = PH_PLAYER_SYNCH_OVERFLOW->subtype;
  say(header, playhouse_c::body(ph_common_uint32_type, ph_common_uint32{lost}));
}

void Peer::serve(const std::function<bool(const Received &)> &rest) {
  while (const auto message = receive()) {
    const bool to_server = message->header.interface_code == PH_PLAYER_CODE;
    if (to_server && message->header.subtype == PH_PLAYER_REQ_DATAMODE->subtype) {
      answer(*message);
    } else if (to_server && message->header.subtype == PH_PLAYER_REQ_DEV->subtype) {
      answer(*message, message->body);
    } else if (!rest(*message)) {
      return;
    }
  }
}

FakeServer::FakeServer(Script script, const std::string &banner)
    : listener_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in here{};
  here.sin_family = AF_INET;
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof here;
  auto *address = reinterpret_cast<sockaddr *>(&here);
  insist(bind(listener_, address, size) == 0 && listen(listener_, 1) == 0, "the fake server cannot listen");
  insist(getsockname(listener_, address, &size) == 0, "the fake server has no port");
  port_ = ntohs(here.sin_port);
  Bytes first(banner.begin(), banner.end());
  if (!first.empty()) first.resize(32);
  thread_ = std::thread([this, script = std::move(script), first] { run(script, first); });
}

const std::vector<Received> &FakeServer::finish() {
  if (thread_.joinable()) thread_.join();
  return received_;
}

void FakeServer::run(const Script &script, const Bytes &banner) {
  const int fd = accept(listener_, nullptr, nullptr);
  close(listener_);
  if (fd < 0) return;
  const int on = 1;
  setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  const timeval patience{30, 0};
  setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  Peer peer(fd, port_);
  peer.send(banner);
  script(peer);
  received_ = std::move(peer.received);
  if (!peer.resets) {  // closing with unread bytes would reset the connection
    shutdown(fd, SHUT_WR);
    std::uint8_t rest[4096];
    while (recv(fd, rest, sizeof rest, 0) > 0) {
    }
  }
  close(fd);
}

FakeServer::Script script(std::function<bool(Peer &, const Received &)> rest) {
  return [rest = std::move(rest)](Peer &peer) {
    peer.serve([&](const Received &message) { return rest(peer, message); });
  };
}

Client connected(const std::string &address, ph_mode mode, double timeout) {
  const ph_options options = {mode, timeout, nullptr};
  ph_error error = {PH_OK, ""};
  Client client(ph_connect(address.c_str(), &options, &error));
  EXPECT_NE(client, nullptr) << error.text;
  return client;
}

}  // namespace playhouse_c
