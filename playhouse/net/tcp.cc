// TCP behind Connection and Listener: one gathered write at a time, no Nagle delay, keep-alive for lost
// peers.

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <optional>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/net/asio_loop.h"
#include "playhouse/net/io_loop.h"

namespace playhouse::net {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::seconds kFlushTime{5};  // a closing connection may use this long to send the rest
constexpr std::chrono::milliseconds kAcceptPause{
    100};  // after an accept that failed, e.g. for want of descriptors
constexpr int kKeepAliveIdle = 30, kKeepAliveInterval = 10, kKeepAliveProbes = 3;  // s, s, count

std::string endpoint_text(const tcp::endpoint& endpoint) {
  const std::string address = endpoint.address().to_string();
  const std::string port = std::to_string(endpoint.port());
  return endpoint.address().is_v6() ? "[" + address + "]:" + port : address + ":" + port;
}

/// The socket and its queue. Shared by the Connection and the operations in progress, which may outlive it.
class TcpStream : public std::enable_shared_from_this<TcpStream> {
 public:
  TcpStream(tcp::socket socket, IoLoop::Impl& loop, std::string peer)
      : socket_(std::move(socket)), loop_(loop), peer_(std::move(peer)), flush_timer_(loop.context) {}

  void start(ConnectionEvents& events) {
    events_ = &events;
    wait_for_bytes();
  }

  void send(std::span<const SharedBytes> parts) {
    if (write_failed_) return;
    for (const SharedBytes& part : parts) {
      in_flight_bytes_ += part->size();
      queued_.push_back(part);
    }
    if (writing_.empty()) write_queued();
  }

  void pause() { paused_ = true; }

  void resume() {
    if (!std::exchange(paused_, false)) return;
    if (events_ && !waiting_) wait_for_bytes();
  }

  void close() {
    events_ = nullptr;
    error_code ignored;
    flush_timer_.cancel(ignored);
    socket_.close(ignored);
  }

  void close_after_flush() {
    events_ = nullptr;
    if (in_flight_bytes_ == 0) return end_of_output();
    closing_ = true;
    flush_timer_.expires_after(kFlushTime);
    flush_timer_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error) self->close();
    });
  }

  std::size_t in_flight_bytes() const { return in_flight_bytes_; }
  const std::string& peer() const { return peer_; }

 private:
  // Waiting for readability and reading into the loop's buffer keeps an idle connection small.
  void wait_for_bytes() {
    waiting_ = true;
    socket_.async_wait(tcp::socket::wait_read, [self = shared_from_this()](const error_code& error) {
      self->waiting_ = false;
      if (!error) self->read();
    });
  }

  void read() {
    if (!events_ || paused_) return;
    error_code error;
    const std::size_t count = socket_.read_some(asio::buffer(loop_.read_buffer), error);
    if (count > 0) events_->received(std::span(loop_.read_buffer).first(count));
    if (!events_) return;  // the owner closed us
    if (error && error != asio::error::would_block && error != asio::error::interrupted) {
      return std::exchange(events_, nullptr)->closed(error == asio::error::eof ? "closed" : error.message());
    }
    if (!paused_) wait_for_bytes();
  }

  void write_queued() {
    writing_ = std::move(queued_);
    queued_.clear();
    std::vector<asio::const_buffer> buffers;
    buffers.reserve(writing_.size());
    for (const SharedBytes& part : writing_) buffers.emplace_back(part->data(), part->size());
    asio::async_write(socket_, buffers, [self = shared_from_this()](const error_code& error, std::size_t) {
      self->written(error);
    });
  }

  void written(const error_code& error) {
    for (const SharedBytes& part : writing_) in_flight_bytes_ -= part->size();
    writing_.clear();
    if (error) return fail_writing();
    if (!queued_.empty()) return write_queued();
    if (closing_) return end_of_output();
    if (events_) events_->drained();
  }

  // What the peer sent before it went away may still wait to be read, so reading goes on to its end.
  void fail_writing() {
    write_failed_ = true;
    queued_.clear();
    in_flight_bytes_ = 0;
    if (closing_) return close();
    resume();
  }

  void end_of_output() {
    error_code ignored;
    socket_.shutdown(tcp::socket::shutdown_both, ignored);
    close();
  }

  tcp::socket socket_;
  IoLoop::Impl& loop_;
  const std::string peer_;
  asio::steady_timer flush_timer_;
  ConnectionEvents* events_ = nullptr;
  std::vector<SharedBytes> writing_, queued_;
  std::size_t in_flight_bytes_ = 0;
  bool waiting_ = false, paused_ = false, closing_ = false, write_failed_ = false;
};

class TcpConnection final : public Connection {
 public:
  explicit TcpConnection(std::shared_ptr<TcpStream> stream) : stream_(std::move(stream)) {}
  ~TcpConnection() override {
    if (!released_) stream_->close();
  }
  void start(ConnectionEvents& events) override { stream_->start(events); }
  void send(std::span<const SharedBytes> parts) override { stream_->send(parts); }
  std::size_t in_flight_bytes() const override { return stream_->in_flight_bytes(); }
  void pause() override { stream_->pause(); }
  void resume() override { stream_->resume(); }
  void close_after_flush() override {
    released_ = true;
    stream_->close_after_flush();
  }
  const std::string& peer() const override { return stream_->peer(); }

 private:
  std::shared_ptr<TcpStream> stream_;
  bool released_ = false;
};

void tune(tcp::socket& socket) {
  error_code ignored;
  socket.non_blocking(true, ignored);
  socket.set_option(tcp::no_delay(true), ignored);
  socket.set_option(asio::socket_base::keep_alive(true), ignored);
  const int descriptor = socket.native_handle();
  setsockopt(descriptor, IPPROTO_TCP, TCP_KEEPIDLE, &kKeepAliveIdle, sizeof kKeepAliveIdle);
  setsockopt(descriptor, IPPROTO_TCP, TCP_KEEPINTVL, &kKeepAliveInterval, sizeof kKeepAliveInterval);
  setsockopt(descriptor, IPPROTO_TCP, TCP_KEEPCNT, &kKeepAliveProbes, sizeof kKeepAliveProbes);
}

/// Accepts for as long as its Listener lives.
class AcceptLoop : public std::enable_shared_from_this<AcceptLoop> {
 public:
  AcceptLoop(IoLoop::Impl& loop, Network::Acceptor acceptor)
      : loop_(loop), acceptor_(loop.context), pause_(loop.context), accept_(std::move(acceptor)) {}

  error_code open(const tcp::endpoint& endpoint) {
    error_code error;
    if (acceptor_.open(endpoint.protocol(), error)) return error;
    acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (endpoint.address().is_v6()) acceptor_.set_option(asio::ip::v6_only(false), error);
    if (acceptor_.bind(endpoint, error)) return error;
    acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (!error) port_ = acceptor_.local_endpoint(error).port();
    return error;
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
    pause_.cancel(ignored);
  }

  std::uint16_t port() const { return port_; }

 private:
  void adopt(tcp::socket socket) {
    error_code error;
    const tcp::endpoint peer = socket.remote_endpoint(error);
    if (error) return;  // gone already
    tune(socket);
    accept_(std::make_unique<TcpConnection>(
        std::make_shared<TcpStream>(std::move(socket), loop_, endpoint_text(peer))));
  }

  // Out of descriptors or memory: the peer waits in the backlog meanwhile.
  void wait_and_retry(const error_code& error) {
    if (!std::exchange(failing_, true)) log::warn("port {}: cannot accept: {}", port_, error.message());
    pause_.expires_after(kAcceptPause);
    pause_.async_wait([self = shared_from_this()](const error_code& cancelled) {
      if (!cancelled && self->acceptor_.is_open()) self->accept_next();
    });
  }

  IoLoop::Impl& loop_;
  tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  Network::Acceptor accept_;
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

Result<std::unique_ptr<Listener>> IoLoop::listen(const std::string& bind, std::uint16_t port,
                                                 Acceptor acceptor) {
  error_code error;
  const auto address = asio::ip::make_address(bind == "localhost" ? "127.0.0.1" : bind, error);
  if (error) return Error{bind, "is not an IPv4 or IPv6 address"};
  auto loop = std::make_shared<AcceptLoop>(*impl_, std::move(acceptor));
  if (const error_code failed = loop->open({address, port})) {
    return Error{endpoint_text({address, port}), "cannot listen: " + failed.message()};
  }
  loop->accept_next();
  return std::unique_ptr<Listener>(std::make_unique<TcpListener>(std::move(loop)));
}

}  // namespace playhouse::net
