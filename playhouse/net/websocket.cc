#include "playhouse/net/websocket.h"

#include <algorithm>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <utility>
#include <variant>

#include "playhouse/base/limits.h"
#include "playhouse/net/asio.h"
#include "playhouse/net/asio_websocket.h"
#include "playhouse/net/websocket_handshake.h"

namespace playhouse::net {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;

/// Time limit of closing with a reason, delivered or not.
constexpr std::chrono::seconds kCloseTime{2};

/// The stream and its queue. Shared by the WebSocket and pending operations, which may outlive it.
class Stream : public std::enable_shared_from_this<Stream> {
 public:
  Stream(beast::tcp_stream stream, std::string peer, std::unique_ptr<HttpPlace> place)
      : socket_(std::move(stream)),
        close_deadline_(socket_.get_executor()),
        peer_(std::move(peer)),
        place_(std::move(place)) {
    if (place_) place_->gives_way([this] { end(); });
    // Pings an idle peer and closes one that does not answer.
    socket_.set_option(websocket::stream_base::timeout{std::chrono::seconds(limits::kHttpHeadSeconds),
                                                       std::chrono::seconds(limits::kHttpIdleSeconds), true});
    socket_.auto_fragment(false);
  }

  void accept(const beast::http::request<beast::http::empty_body>& request,
              std::function<void(const std::shared_ptr<Stream>&)> done) {
    answer_handshake(socket_, request,
                     [self = shared_from_this(), done = std::move(done)](const error_code& error) {
                       if (error || self->ended_) return;
                       if (self->place_) self->place_->stays();
                       done(self);
                     });
  }

  void start(WebSocketEvents& events) {
    events_ = &events;
    socket_.read_message_max(events.message_bytes());
    read();
  }

  void send(std::variant<std::shared_ptr<const std::string>, SharedBytes> message) {
    if (closing_ || failed_) return;
    queued_.push_back(std::move(message));
    if (queued_.size() == 1) write();
  }

  void pause() { paused_ = true; }

  void resume() {
    paused_ = false;
    if (events_ && !reading_) read();
  }

  std::size_t messages_in_flight() const { return queued_.size(); }
  const std::string& peer() const { return peer_; }

  void close(std::string reason) {
    if (closing_ || failed_) return;
    if (queued_.size() > 1) queued_.resize(1);  // drops all but the current write
    close_within(kCloseTime, std::move(reason));
  }

  void close_after_flush(std::string reason) {
    if (closing_ || failed_) return;
    close_within(std::chrono::seconds(kFlushSeconds), std::move(reason));
  }

  void drop() {
    events_ = nullptr;
    if (!closing_) end();
  }

 private:
  void read() {
    reading_ = true;
    socket_.async_read(buffer_, [self = shared_from_this()](const error_code& error, std::size_t) {
      self->read_done(error);
    });
  }

  void read_done(const error_code& error) {
    if (error) return fail(error == websocket::error::closed ? "closed" : error.message());
    if (events_) {
      const auto bytes = buffer_.cdata();
      if (socket_.got_text()) {
        events_->received({static_cast<const char*>(bytes.data()), bytes.size()});
      } else if (!events_->received_bytes({static_cast<const std::byte*>(bytes.data()), bytes.size()})) {
        return fail("sent a binary message");
      }
    }
    buffer_.clear();
    reading_ = false;
    if (closing_ || (events_ && !paused_)) read();
  }

  void close_within(std::chrono::seconds time, std::string reason) {
    events_ = nullptr;
    closing_ = true;
    if (place_) place_->gives_way([this] { end(); });
    reason_ = std::move(reason);
    close_deadline_.expires_after(time);
    close_deadline_.async_wait([weak = weak_from_this()](const error_code&) {
      if (const auto self = weak.lock()) self->end();
    });
    if (queued_.empty()) send_close();
  }

  void fail(const std::string& why) {
    failed_ = true;
    if (events_) std::exchange(events_, nullptr)->closed(why);
    end();
  }

  void end() {
    ended_ = true;
    beast::get_lowest_layer(socket_).close();
    place_.reset();
  }

  void write() {
    const auto& message = queued_.front();
    const bool text = message.index() == 0;
    const asio::const_buffer bytes =
        text ? asio::buffer(*std::get<0>(message)) : asio::buffer(*std::get<1>(message));
    socket_.text(text);
    socket_.async_write(bytes, [self = shared_from_this()](const error_code& error, std::size_t) {
      self->write_done(error);
    });
  }

  void write_done(const error_code& error) {
    queued_.pop_front();
    if (error) {
      queued_.clear();
      return fail(error.message());
    }
    if (!queued_.empty()) return write();
    if (closing_) return send_close();
    if (events_) events_->drained();
  }

  /// Beast's close waits for a pending read, which on failure waits
  /// for the close: a deadlock. So the close frame (RFC 6455 5.5.1)
  /// is written directly, and input is drained to the peer's end.
  void send_close() {
    constexpr std::size_t kMostBytes = 123;  // of a reason
    constexpr auto kCode = static_cast<unsigned>(websocket::close_code::policy_error);
    reason_.resize(std::min(reason_.size(), kMostBytes));
    const char head[] = {'\x88', static_cast<char>(2 + reason_.size()), static_cast<char>(kCode >> 8),
                         static_cast<char>(kCode & 0xFF)};
    reason_.insert(0, head, sizeof head);
    asio::async_write(tcp(), asio::buffer(reason_),
                      [self = shared_from_this()](const error_code& error, std::size_t) {
                        if (error) return self->end();
                        error_code ignored;
                        self->tcp().shutdown(asio::socket_base::shutdown_send, ignored);
                      });
    if (!reading_) read();
  }

  asio::ip::tcp::socket& tcp() { return beast::get_lowest_layer(socket_).socket(); }

  WebSocketStream socket_;
  asio::steady_timer close_deadline_;
  const std::string peer_;
  std::unique_ptr<HttpPlace> place_;  // while the socket is open; null: it has none
  bool ended_ = false;
  beast::flat_buffer buffer_;
  std::deque<std::variant<std::shared_ptr<const std::string>, SharedBytes>> queued_;  // front: being written
  WebSocketEvents* events_ = nullptr;
  std::string reason_;    // close reason; then the whole frame
  bool reading_ = false;  // until the input was processed
  bool paused_ = false, closing_ = false, failed_ = false;
};

class BeastWebSocket final : public WebSocket {
 public:
  explicit BeastWebSocket(std::shared_ptr<Stream> stream) : stream_(std::move(stream)) {}
  ~BeastWebSocket() override { stream_->drop(); }
  void start(WebSocketEvents& events) override { stream_->start(events); }
  void send_text(std::shared_ptr<const std::string> text) override { stream_->send(std::move(text)); }
  void send_binary(SharedBytes bytes) override { stream_->send(std::move(bytes)); }
  void pause() override { stream_->pause(); }
  void resume() override { stream_->resume(); }
  std::size_t messages_in_flight() const override { return stream_->messages_in_flight(); }
  void close(std::string reason) override { stream_->close(std::move(reason)); }
  void close_after_flush(std::string reason) override { stream_->close_after_flush(std::move(reason)); }
  const std::string& peer() const override { return stream_->peer(); }

 private:
  std::shared_ptr<Stream> stream_;
};

}  // namespace

void accept_websocket(beast::tcp_stream stream, const beast::http::request<beast::http::empty_body>& request,
                      std::string peer, std::unique_ptr<HttpPlace> place,
                      std::function<void(std::unique_ptr<WebSocket>)> done) {
  beast::get_lowest_layer(stream).expires_never();  // WebSockets have timeouts of their own
  auto made = std::make_shared<Stream>(std::move(stream), std::move(peer), std::move(place));
  made->accept(request, [done = std::move(done)](const std::shared_ptr<Stream>& ready) {
    done(std::make_unique<BeastWebSocket>(ready));
  });
}

}  // namespace playhouse::net
