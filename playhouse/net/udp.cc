/// UDP sockets of the io loop.

#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <functional>
#include <optional>
#include <utility>

#include "playhouse/net/asio_loop.h"
#include "playhouse/net/local/spoken_to.h"

#include "playhouse/net/asio.h"

namespace playhouse::net {
namespace {

using asio::ip::udp;

/// Datagrams per turn, before other events of the loop.
constexpr int kDatagramsPerTurn = 64;
/// Kernel buffer size, large enough for a burst to all clients.
constexpr int kSystemBytes = 1 << 20;

udp::endpoint to_asio(const Endpoint& endpoint, bool as_v4) {
  const asio::ip::address_v6 six(endpoint.address, endpoint.scope);
  if (as_v4 && endpoint.is_v4()) return {asio::ip::make_address_v4(asio::ip::v4_mapped, six), endpoint.port};
  return {six, endpoint.port};
}

Endpoint from_asio(const udp::endpoint& endpoint) {
  const asio::ip::address address = endpoint.address();
  const asio::ip::address_v6 six =
      address.is_v6() ? address.to_v6() : asio::ip::make_address_v6(asio::ip::v4_mapped, address.to_v4());
  return {six.to_bytes(), endpoint.port(), static_cast<std::uint32_t>(six.scope_id())};
}

/// Receives during its socket's lifetime.
class ReadLoop : public std::enable_shared_from_this<ReadLoop> {
 public:
  ReadLoop(IoLoop::Impl& loop, DatagramSocket::Receiver receiver)
      : loop_(loop), socket_(loop.context), receiver_(std::move(receiver)) {}

  error_code open(const udp::endpoint& endpoint) {
    error_code error;
    if (socket_.open(endpoint.protocol(), error)) return error;
    is_v4_ = endpoint.address().is_v4();
    error_code ignored;
    if (!is_v4_) socket_.set_option(asio::ip::v6_only(false), ignored);
    if (endpoint.address().is_unspecified()) tell_spoken_to(socket_.native_handle(), is_v4_);
    socket_.set_option(asio::socket_base::receive_buffer_size(kSystemBytes), ignored);
    socket_.set_option(asio::socket_base::send_buffer_size(kSystemBytes), ignored);
    if (socket_.bind(endpoint, error)) return error;
    socket_.non_blocking(true, error);
    if (!error) port_ = socket_.local_endpoint(error).port();
    return error;
  }

  void read_next() {
    socket_.async_wait(udp::socket::wait_read, [self = shared_from_this()](const error_code& error) {
      if (error || !self->socket_.is_open()) return;
      self->read();
      if (self->socket_.is_open()) self->read_next();
    });
  }

  // An error of an earlier datagram may be told by this call, which then has not sent.
  bool send(const Endpoint& to, std::span<const std::byte> bytes) {
    const udp::endpoint there = to_asio(to, is_v4_);
    const auto size = static_cast<socklen_t>(there.size());
    for (int tries = 0; tries < 2; ++tries) {
      if (send_datagram(socket_.native_handle(), bytes, there.data(), size, to.spoken_to)) return true;
      if (errno != ECONNREFUSED) break;
    }
    return false;
  }

  void on_refused(std::function<void(const Endpoint&)> refused) {
    refused_ = std::move(refused);
    const int on = 1;
    const int socket = socket_.native_handle();
    setsockopt(socket, IPPROTO_IP, IP_RECVERR, &on, sizeof on);
    if (!is_v4_) setsockopt(socket, IPPROTO_IPV6, IPV6_RECVERR, &on, sizeof on);
    wait_for_refusal();
  }

  void close() {
    error_code ignored;
    socket_.close(ignored);
  }

  std::uint16_t port() const { return port_; }

 private:
  void read() {
    for (int count = 0; count < kDatagramsPerTurn && socket_.is_open(); ++count) {
      udp::endpoint from;
      auto length = static_cast<socklen_t>(from.capacity());
      OwnAddress spoken_to{};
      const std::optional<std::size_t> size =
          receive_datagram(socket_.native_handle(), loop_.read_buffer, from.data(), length, spoken_to);
      if (!size && errno == ECONNREFUSED) continue;  // of one sent before: wait_for_refusal()
      if (!size) return;                             // none left
      from.resize(length);
      Endpoint peer = from_asio(from);
      peer.spoken_to = spoken_to;
      receiver_(peer, std::span(loop_.read_buffer).first(*size));
    }
  }

  void wait_for_refusal() {
    socket_.async_wait(udp::socket::wait_error, [self = shared_from_this()](const error_code& error) {
      if (error || !self->socket_.is_open()) return;
      while (const std::optional<Endpoint> peer = self->next_refusal()) self->refused_(*peer);
      if (self->socket_.is_open()) self->wait_for_refusal();
    });
  }

  /// Of the system's queue of errors, which has where a datagram was sent to (ip(7)).
  std::optional<Endpoint> next_refusal() {
    for (;;) {
      udp::endpoint peer;
      alignas(cmsghdr) std::array<std::byte, 512> control{};
      msghdr message{};
      message.msg_name = peer.data();
      message.msg_namelen = static_cast<socklen_t>(peer.capacity());
      message.msg_control = control.data();
      message.msg_controllen = control.size();
      if (!socket_.is_open() || ::recvmsg(socket_.native_handle(), &message, MSG_ERRQUEUE) < 0) return {};
      peer.resize(message.msg_namelen);
      if (error_in(message) == ECONNREFUSED) return from_asio(peer);
    }
  }

  IoLoop::Impl& loop_;
  udp::socket socket_;
  DatagramSocket::Receiver receiver_;
  std::function<void(const Endpoint&)> refused_;
  std::uint16_t port_ = 0;
  bool is_v4_ = true;
};

class UdpSocket final : public DatagramSocket {
 public:
  explicit UdpSocket(std::shared_ptr<ReadLoop> loop) : loop_(std::move(loop)) {}
  ~UdpSocket() override { loop_->close(); }
  bool send(const Endpoint& to, std::span<const std::byte> bytes) override { return loop_->send(to, bytes); }
  void on_refused(std::function<void(const Endpoint&)> refused) override {
    loop_->on_refused(std::move(refused));
  }
  std::uint16_t port() const override { return loop_->port(); }

 private:
  std::shared_ptr<ReadLoop> loop_;
};

}  // namespace

Result<std::unique_ptr<DatagramSocket>> IoLoop::open_datagrams(const std::string& bind, std::uint16_t port,
                                                               DatagramSocket::Receiver receiver) {
  const Result<Endpoint> here = parse_endpoint(bind, port);
  if (!here) return here.error();
  auto loop = std::make_shared<ReadLoop>(*impl_, std::move(receiver));
  if (const error_code failed = loop->open(to_asio(*here, true)))
    return Error{to_text(*here), "cannot listen for datagrams: " + failed.message()};
  loop->read_next();
  return std::unique_ptr<DatagramSocket>(std::make_unique<UdpSocket>(std::move(loop)));
}

}  // namespace playhouse::net
