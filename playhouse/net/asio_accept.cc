#include "playhouse/net/asio_accept.h"

#include <netinet/tcp.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/net/asio.h"
#include "playhouse/net/local/unix_socket.h"
#include "playhouse/net/tls/decrypt.h"

namespace playhouse::net {
namespace {

using asio::ip::tcp;

constexpr std::chrono::milliseconds kAcceptPause{
    100};  // pause after a failed accept, e.g. without free descriptors
constexpr int kKeepAliveIdle = 20, kKeepAliveInterval = 8, kKeepAliveProbes = 4;  // s, s, count
// Further seconds, by the connection: thousands that were made together and are silent must not be probed together, as
// queues on the way drop what exceeds them and a connection without an answer is lost.
constexpr int kKeepAliveSpread = 31, kKeepAliveIntervalSpread = 5;

/// Accepts connections during its Listener's lifetime.
class AcceptLoop : public std::enable_shared_from_this<AcceptLoop> {
 public:
  AcceptLoop(IoLoop::Impl& loop, SocketAcceptor acceptor)
      : loop_(loop), acceptor_(loop.context), pause_(loop.context), accept_(std::move(acceptor)) {}

  error_code open(const tcp::endpoint& endpoint) {
    error_code error;
    if (acceptor_.open(endpoint.protocol(), error)) return error;
    acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (endpoint.address().is_v6()) acceptor_.set_option(asio::ip::v6_only(false), error);
    if (acceptor_.bind(endpoint, error)) return error;
    acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (!error) port_ = acceptor_.local_endpoint(error).port();
    tls_ = loop_.tls;
    return error;
  }

  /// Without TLS: the line does not leave the machine.
  Result<void> open_unix(const std::string& folder, std::uint16_t port) {
    Result<UnixListening> opened = listen_unix(folder, port);
    if (!opened) return opened.error();
    unix_ = std::move(*opened);
    port_ = port;
    error_code error;
    acceptor_.assign(tcp::v4(), unix_->descriptor, error);
    if (!error) return {};
    ::close(unix_->descriptor);
    unix_->remove();
    return Error{unix_->path, "cannot listen: " + error.message()};
  }

  void accept_next() {
    acceptor_.async_accept([self = shared_from_this()](const error_code& error, tcp::socket socket) {
      if (!self->acceptor_.is_open()) return;
      if (error) return self->wait_and_retry(error);
      self->failing_ = false;
      self->adopt(std::move(socket));
      if (self->acceptor_.is_open()) self->accept_next();
    });
  }

  void close() {
    error_code ignored;
    acceptor_.close(ignored);
    if (unix_) unix_->remove();
    pause_.cancel(ignored);
  }

  std::uint16_t port() const { return port_; }

 private:
  std::optional<std::string> peer_of(tcp::socket& socket) const {
    if (unix_) return unix_peer(socket.native_handle());
    error_code error;
    const tcp::endpoint peer = socket.remote_endpoint(error);
    return error ? std::nullopt : std::optional(endpoint_text(peer));
  }

  void adopt(tcp::socket socket) {
    const std::optional<std::string> peer = peer_of(socket);
    if (!peer) return;  // disconnected already
    tune(socket);
    if (!tls_) return accept_({std::move(socket), *peer, {}, false});
    decrypt(loop_, tls_, std::move(socket),
            [self = shared_from_this(), peer = *peer](Result<Decrypted> decrypted) {
              if (!self->acceptor_.is_open()) return;
              if (!decrypted) return self->warn_of_handshake(peer, decrypted.error().line());
              self->accept_({std::move(decrypted->socket), peer, std::move(decrypted->expect_alive), true});
            });
  }

  void warn_of_handshake(const std::string& peer, const std::string& why) {
    log::warn("port {}: {} refused: invalid TLS handshake: {}", port_, peer, why);
  }

  // Out of descriptors or memory: the peer stays in the
  // backlog, and lingering connections are closed to free some.
  void wait_and_retry(const error_code& error) {
    if (!std::exchange(failing_, true)) log::warn("port {}: cannot accept: {}", port_, error.message());
    loop_.end_lingering();
    pause_.expires_after(kAcceptPause);
    pause_.async_wait([self = shared_from_this()](const error_code& cancelled) {
      if (!cancelled && self->acceptor_.is_open()) self->accept_next();
    });
  }

  IoLoop::Impl& loop_;
  std::shared_ptr<TlsIdentity> tls_;   // null: in the clear
  std::optional<UnixListening> unix_;  // none: TCP
  tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  SocketAcceptor accept_;
  std::uint16_t port_ = 0;
  bool failing_ = false;
};

class TcpListener final : public Listener {
 public:
  explicit TcpListener(std::shared_ptr<AcceptLoop> loop) : loop_(std::move(loop)) {}
  ~TcpListener() override { loop_->close(); }
  std::uint16_t port() const override { return loop_->port(); }

 private:
  std::shared_ptr<AcceptLoop> loop_;
};

}  // namespace

std::string endpoint_text(const tcp::endpoint& endpoint) {
  const std::string address = endpoint.address().to_string();
  const std::string port = std::to_string(endpoint.port());
  return endpoint.address().is_v6() ? "[" + address + "]:" + port : address + ":" + port;
}

void tune(tcp::socket& socket) {
  error_code ignored;
  socket.non_blocking(true, ignored);
  socket.set_option(tcp::no_delay(true), ignored);
  socket.set_option(asio::socket_base::keep_alive(true), ignored);
  const int descriptor = socket.native_handle();
  const int idle = kKeepAliveIdle + descriptor % kKeepAliveSpread;
  const int interval = kKeepAliveInterval + descriptor % kKeepAliveIntervalSpread;
  setsockopt(descriptor, IPPROTO_TCP, TCP_KEEPIDLE, &idle, sizeof idle);
  setsockopt(descriptor, IPPROTO_TCP, TCP_KEEPINTVL, &interval, sizeof interval);
  setsockopt(descriptor, IPPROTO_TCP, TCP_KEEPCNT, &kKeepAliveProbes, sizeof kKeepAliveProbes);
}

void expect_alive(tcp::socket& socket) {
  const unsigned milliseconds = kAliveSeconds * 1000;
  setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_USER_TIMEOUT, &milliseconds, sizeof milliseconds);
}

bool has_fault(tcp::socket& socket) {
  pollfd looked{socket.native_handle(), 0, 0};
  return ::poll(&looked, 1, 0) > 0 && (looked.revents & (POLLERR | POLLHUP)) != 0;
}

Result<std::unique_ptr<Listener>> listen_tcp(IoLoop::Impl& impl, const std::string& bind, std::uint16_t port,
                                             SocketAcceptor acceptor) {
  auto loop = std::make_shared<AcceptLoop>(impl, std::move(acceptor));
  if (is_unix_folder(bind)) {
    if (const Result<void> opened = loop->open_unix(bind, port); !opened) return opened.error();
    loop->accept_next();
    return std::unique_ptr<Listener>(std::make_unique<TcpListener>(std::move(loop)));
  }
  error_code error;
  const auto address = asio::ip::make_address(bind == "localhost" ? "127.0.0.1" : bind, error);
  if (error) return Error{bind, "is not an IPv4 or IPv6 address"};
  if (const error_code failed = loop->open({address, port})) {
    return Error{endpoint_text({address, port}), "cannot listen: " + failed.message()};
  }
  loop->accept_next();
  return std::unique_ptr<Listener>(std::make_unique<TcpListener>(std::move(loop)));
}

}  // namespace playhouse::net
