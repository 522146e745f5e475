#include "playhouse/net/asio_connect.h"

#include <chrono>
#include <utility>

#include "playhouse/net/asio.h"
#include "playhouse/net/asio_accept.h"
#include "playhouse/net/local/unix_socket.h"

namespace playhouse::net {
namespace {

using asio::ip::tcp;

/// A connection attempt. Shared by its handle and pending operations, which may outlive that.
class Connecting : public std::enable_shared_from_this<Connecting> {
 public:
  Connecting(IoLoop::Impl& loop, const std::string& host, std::uint16_t port, SocketConnected connected)
      : resolver_(loop.context),
        socket_(loop.context),
        patience_(loop.context),
        host_(host),
        port_(port),
        connected_(std::move(connected)) {}

  void begin() {
    patience_.expires_after(std::chrono::seconds(kConnectSeconds));
    patience_.async_wait([self = shared_from_this()](const error_code& cancelled) {
      if (!cancelled) self->fail("no answer within " + std::to_string(kConnectSeconds) + " s");
    });
    if (is_unix_folder(host_))
      return asio::post(socket_.get_executor(), [self = shared_from_this()] { self->connect_unix_socket(); });
    error_code no_address;
    const auto address = asio::ip::make_address(host_ == "localhost" ? "127.0.0.1" : host_, no_address);
    if (!no_address) {
      endpoints_ = {tcp::endpoint(address, port_)};
      return connect();
    }
    resolver_.async_resolve(host_, std::to_string(port_), tcp::resolver::numeric_service,
                            [self = shared_from_this()](const error_code& error, const auto& found) {
                              if (error) return self->fail(error.message());
                              for (const auto& each : found) self->endpoints_.push_back(each.endpoint());
                              self->connect();
                            });
  }

  /// Cancels; no event follows.
  void give_up() {
    connected_ = nullptr;
    end();
  }

 private:
  void connect() {
    if (!connected_) return;
    asio::async_connect(socket_, endpoints_,
                        [self = shared_from_this()](const error_code& error, const tcp::endpoint& endpoint) {
                          error ? self->fail(error.message()) : self->succeed(endpoint);
                        });
  }

  void connect_unix_socket() {
    if (!connected_) return;
    const Result<int> made = connect_unix(host_, port_);
    if (!made) return fail(made.error());
    error_code error;
    socket_.assign(tcp::v4(), *made, error);
    error ? fail(error.message()) : succeed(host_ + ":" + std::to_string(port_));
  }

  void succeed(const tcp::endpoint& endpoint) { succeed(endpoint_text(endpoint)); }

  void succeed(const std::string& peer) {
    if (!connected_) return;
    tune(socket_);
    patience_.cancel();
    std::exchange(connected_, nullptr)(ConnectedSocket{std::move(socket_), peer});
  }

  void fail(const std::string& why) {
    fail(Error{
        (host_.find(':') == std::string::npos ? host_ : "[" + host_ + "]") + ":" + std::to_string(port_),
        "cannot connect: " + why});
  }

  void fail(const Error& why) {
    if (!connected_) return;
    end();
    std::exchange(connected_, nullptr)(why);
  }

  void end() {
    error_code ignored;
    resolver_.cancel();
    patience_.cancel();
    socket_.close(ignored);
  }

  tcp::resolver resolver_;
  tcp::socket socket_;
  asio::steady_timer patience_;
  const std::string host_;
  const std::uint16_t port_;
  std::vector<tcp::endpoint> endpoints_;
  SocketConnected connected_;  // empty once called or cancelled
};

class TcpAttempt final : public Attempt {
 public:
  explicit TcpAttempt(std::shared_ptr<Connecting> connecting) : connecting_(std::move(connecting)) {}
  ~TcpAttempt() override { connecting_->give_up(); }

 private:
  std::shared_ptr<Connecting> connecting_;
};

}  // namespace

std::unique_ptr<Attempt> connect_tcp(IoLoop::Impl& impl, const std::string& host, std::uint16_t port,
                                     SocketConnected connected) {
  auto connecting = std::make_shared<Connecting>(impl, host, port, std::move(connected));
  connecting->begin();
  return std::make_unique<TcpAttempt>(std::move(connecting));
}

}  // namespace playhouse::net
