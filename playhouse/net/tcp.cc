// TCP connections: one gathered write at a time, graceful close.

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "playhouse/net/asio.h"
#include "playhouse/net/asio_accept.h"
#include "playhouse/net/asio_connect.h"
#include "playhouse/net/asio_loop.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/tls/decrypt.h"

namespace playhouse::net {
namespace {

using asio::ip::tcp;

constexpr std::size_t kGathered = 64;  // parts in one call, which are as many as asio gives the system
constexpr std::chrono::seconds kLingerTime{1};  // and then its peer this long to end

bool is_end(const error_code& error) {
  return error && error != asio::error::would_block && error != asio::error::interrupted;
}

/// The socket and its queue. Shared by the Connection and pending operations, which may outlive it.
class TcpStream : public std::enable_shared_from_this<TcpStream> {
 public:
  TcpStream(IoLoop::Impl& loop, AcceptedSocket accepted)
      : socket_(std::move(accepted.socket)),
        loop_(loop),
        peer_(std::move(accepted.peer)),
        expect_alive_(std::move(accepted.expect_alive)),
        end_timer_(loop.context) {}

  void start(ConnectionEvents& events) {
    events_ = &events;
    wait_for_bytes();
  }

  void send(std::span<const SharedBytes> parts) {
    if (peer_lost_) return;
    for (const SharedBytes& part : parts) {
      in_flight_bytes_ += part->size();
      queued_.push_back(part);
    }
    if (writing_.empty()) write_queued();
  }

  void pause() {
    paused_ = true;
    if (!waiting_for_fault_ && !peer_lost_) wait_for_fault();
  }

  void resume() {
    if (!std::exchange(paused_, false)) return;
    if (events_ && !waiting_ && !read_to_end_) wait_for_bytes();
  }

  void close() {
    events_ = nullptr;
    if (lingering_) loop_.leave(*std::exchange(lingering_, {}));
    error_code ignored;
    end_timer_.cancel(ignored);
    socket_.close(ignored);
  }

  void close_after_flush() {
    events_ = nullptr;
    if (in_flight_bytes_ == 0) return end_of_output();
    closing_ = true;
    close_after(std::chrono::seconds(kFlushSeconds));
  }

  std::size_t in_flight_bytes() const { return in_flight_bytes_; }
  void expect_alive() { expect_alive_ ? expect_alive_() : net::expect_alive(socket_); }
  const std::string& peer() const { return peer_; }

 private:
  // Waits for readability before reading into the loop's shared buffer: idle connections need no buffer.
  void wait_for_bytes() {
    waiting_ = true;
    socket_.async_wait(tcp::socket::wait_read, [self = shared_from_this()](const error_code& error) {
      self->waiting_ = false;
      if (!error) self->read();
    });
  }

  void read() {
    if (lingering_) return discard();
    if (!events_ || paused_) return;
    error_code error;
    const std::size_t count = socket_.read_some(asio::buffer(loop_.read_buffer), error);
    if (count > 0) events_->received(std::span(loop_.read_buffer).first(count));
    if (!events_) return;  // closed by the owner
    if (is_end(error)) return end_reading(error);
    if (!paused_) wait_for_bytes();
  }

  // Detects a reset or timeout while reading is paused. The wait is
  // not cancelled on resume: reading could not go on after that.
  void wait_for_fault() {
    waiting_for_fault_ = true;
    socket_.async_wait(tcp::socket::wait_error, [self = shared_from_this()](const error_code& error) {
      self->waiting_for_fault_ = false;
      if (error || !self->events_ || !self->paused_ || self->peer_lost_) return;
      has_fault(self->socket_) ? self->lose_peer() : self->wait_for_fault();
    });
  }

  void end_reading(const error_code& error) {
    read_to_end_ = true;
    if (error == asio::error::eof) return events_->closed("closed");
    lose_peer();
    if (events_) events_->closed(error.message());
  }

  void write_queued() {
    writing_ = std::move(queued_);
    queued_.clear();
    next_part_ = next_byte_ = 0;
    write();
  }

  // Writes as much as the system accepts: asio::async_write
  // would yield to the loop after every 16 parts.
  void write() {
    error_code error;
    while (next_part_ < writing_.size() && !error) write_some(error);
    if (error && !is_end(error)) return wait_for_room();
    asio::post(socket_.get_executor(), [self = shared_from_this(), error] { self->written(error); });
  }

  void write_some(error_code& error) {
    std::array<asio::const_buffer, kGathered> buffers;
    const std::size_t count = std::min(kGathered, writing_.size() - next_part_);
    for (std::size_t i = 0; i < count; ++i) buffers[i] = asio::buffer(*writing_[next_part_ + i]);
    buffers[0] += next_byte_;
    next_byte_ += socket_.write_some(std::span<const asio::const_buffer>(buffers.data(), count), error);
    while (next_part_ < writing_.size() && next_byte_ >= writing_[next_part_]->size())
      next_byte_ -= writing_[next_part_++]->size();
  }

  void wait_for_room() {
    socket_.async_wait(tcp::socket::wait_write, [self = shared_from_this()](const error_code& error) {
      error ? self->written(error) : self->write();
    });
  }

  void written(const error_code& error) {
    if (peer_lost_) return writing_.clear();
    for (const SharedBytes& part : writing_) in_flight_bytes_ -= part->size();
    writing_.clear();
    if (error) return lose_peer();
    if (!queued_.empty()) return write_queued();
    if (closing_) return end_of_output();
    if (events_) events_->drained();
  }

  // Data received before the reset may be unread.
  void lose_peer() {
    if (std::exchange(peer_lost_, true)) return;
    queued_.clear();
    in_flight_bytes_ = 0;
    if (closing_) return close();
    if (events_) events_->lost();
  }

  // Half-closes and drains input to the peer's end: closing with unread
  // input would send RST, which discards unread data at the peer.
  void end_of_output() {
    if (read_to_end_) return close();
    error_code ignored;
    socket_.shutdown(tcp::socket::shutdown_send, ignored);
    lingering_ = loop_.linger([this] { close(); });
    close_after(kLingerTime);
    if (!waiting_) wait_for_bytes();
  }

  void discard() {
    error_code error;
    socket_.read_some(asio::buffer(loop_.read_buffer), error);
    is_end(error) ? close() : wait_for_bytes();
  }

  void close_after(std::chrono::seconds time) {
    end_timer_.expires_after(time);
    end_timer_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error) self->close();
    });
  }

  tcp::socket socket_;
  IoLoop::Impl& loop_;
  const std::string peer_;
  const std::function<void()> expect_alive_;  // of a line that is not the socket
  asio::steady_timer end_timer_;              // after release by the owner
  ConnectionEvents* events_ = nullptr;
  std::vector<SharedBytes> writing_, queued_;
  std::size_t next_part_ = 0, next_byte_ = 0;  // of writing_: first part and byte not accepted yet
  std::size_t in_flight_bytes_ = 0;
  std::optional<IoLoop::Impl::Lingering::iterator> lingering_;  // after flushing
  bool waiting_ = false, paused_ = false, read_to_end_ = false, closing_ = false, peer_lost_ = false;
  bool waiting_for_fault_ = false;
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
  void expect_alive() override { stream_->expect_alive(); }
  const std::string& peer() const override { return stream_->peer(); }

 private:
  std::shared_ptr<TcpStream> stream_;
  bool released_ = false;
};

}  // namespace

Result<std::unique_ptr<Listener>> IoLoop::listen(const std::string& bind, std::uint16_t port,
                                                 Acceptor acceptor) {
  return listen_tcp(*impl_, bind, port, [this, acceptor = std::move(acceptor)](AcceptedSocket accepted) {
    acceptor(std::make_unique<TcpConnection>(std::make_shared<TcpStream>(*impl_, std::move(accepted))));
  });
}

namespace {

/// Of a connection with TLS. What comes of its handshake once it has been given up is closed.
class TlsAttempt final : public Attempt {
 public:
  using Connected = std::shared_ptr<Network::Connected>;

  explicit TlsAttempt(Connected connected) : connected_(std::move(connected)) {}
  ~TlsAttempt() override { *connected_ = nullptr; }
  std::unique_ptr<Attempt> without;  // TLS

 private:
  const Connected connected_;
};

}  // namespace

std::unique_ptr<Attempt> IoLoop::connect_tls(const std::string& host, std::uint16_t port,
                                             std::shared_ptr<TlsTrust> trust, Connected connected) {
  const auto then = std::make_shared<Connected>(std::move(connected));
  auto attempt = std::make_unique<TlsAttempt>(then);
  const auto tell = [then](Result<std::unique_ptr<Connection>> made) {
    if (*then) std::exchange(*then, nullptr)(std::move(made));
  };
  attempt->without = connect_tcp(*impl_, host, port, [this, tell, host, trust](Result<ConnectedSocket> made) {
    if (!made) return tell(made.error());
    decrypt_from(*impl_, trust, host, std::move(made->socket),
                 [this, tell, peer = std::move(made->peer)](Result<Decrypted> decrypted) {
                   if (!decrypted)
                     return tell(Error{peer, "invalid TLS handshake: " + decrypted.error().text});
                   AcceptedSocket accepted{std::move(decrypted->socket), peer,
                                           std::move(decrypted->expect_alive), true};
                   tell(std::unique_ptr<Connection>(std::make_unique<TcpConnection>(
                       std::make_shared<TcpStream>(*impl_, std::move(accepted)))));
                 });
  });
  return attempt;
}

std::unique_ptr<Attempt> IoLoop::connect(const std::string& host, std::uint16_t port, Connected connected) {
  return connect_tcp(
      *impl_, host, port, [this, connected = std::move(connected)](Result<ConnectedSocket> made) {
        if (!made) return connected(made.error());
        connected(std::unique_ptr<Connection>(std::make_unique<TcpConnection>(std::make_shared<TcpStream>(
            *impl_, AcceptedSocket{std::move(made->socket), std::move(made->peer), {}, false}))));
      });
}

}  // namespace playhouse::net
