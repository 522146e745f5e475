#include "playhouse/net/websocket.h"

#include <algorithm>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <utility>
#include <variant>

#include "playhouse/base/limits.h"
#include "playhouse/net/asio_websocket.h"

namespace playhouse::net {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using beast::error_code;

/// The stream and its queue. Shared by the WebSocket and the operations in progress, which may outlive it.
class Stream : public std::enable_shared_from_this<Stream> {
 public:
  Stream(beast::tcp_stream stream, std::string peer) : socket_(std::move(stream)), peer_(std::move(peer)) {
    // Pings an idle peer and closes one that does not answer.
    socket_.set_option(websocket::stream_base::timeout{std::chrono::seconds(10),
                                                       std::chrono::seconds(limits::kHttpIdleSeconds), true});
    socket_.read_message_max(limits::kViewerCommandBytes);
    socket_.auto_fragment(false);
  }

  template <typename Request, typename Done>
  void accept(const Request& request, Done done) {
    socket_.async_accept(request,
                         [self = shared_from_this(), done = std::move(done)](const error_code& error) {
                           if (!error) done(self);
                         });
  }

  void start(WebSocketEvents& events) {
    events_ = &events;
    read();
  }

  void send(std::variant<std::shared_ptr<const std::string>, SharedBytes> message) {
    if (closing_ || failed_) return;
    queued_.push_back(std::move(message));
    if (queued_.size() == 1) write();
  }

  std::size_t messages_in_flight() const { return queued_.size(); }
  const std::string& peer() const { return peer_; }

  void close(std::string reason) {
    events_ = nullptr;
    closing_ = true;
    reason_ = std::move(reason);
    if (queued_.size() > 1) queued_.resize(1);  // only what is being written goes out
    if (queued_.empty()) say_goodbye();
  }

  void drop() {
    events_ = nullptr;
    if (!closing_) beast::get_lowest_layer(socket_).close();
  }

 private:
  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](const error_code& error, std::size_t) {
      self->read_done(error);
    });
  }

  void read_done(const error_code& error) {
    if (!events_) return;
    if (error) return fail(error == websocket::error::closed ? "closed" : error.message());
    if (!socket_.got_text()) return fail("sent a binary message");
    const auto bytes = buffer_.cdata();
    events_->received({static_cast<const char*>(bytes.data()), bytes.size()});
    buffer_.consume(buffer_.size());
    if (events_) read();
  }

  void fail(const std::string& why) {
    failed_ = true;
    if (events_) std::exchange(events_, nullptr)->closed(why);
    beast::get_lowest_layer(socket_).close();
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
    if (closing_) return say_goodbye();
    if (events_) events_->drained();
  }

  void say_goodbye() {
    websocket::close_reason reason(websocket::close_code::policy_error);
    reason.reason.assign(reason_.data(), std::min(reason_.size(), reason.reason.max_size()));
    socket_.async_close(reason, [self = shared_from_this()](const error_code&) {});
  }

  websocket::stream<beast::tcp_stream> socket_;
  const std::string peer_;
  beast::flat_buffer buffer_;
  std::deque<std::variant<std::shared_ptr<const std::string>, SharedBytes>> queued_;  // front: being written
  WebSocketEvents* events_ = nullptr;
  std::string reason_;
  bool closing_ = false, failed_ = false;
};

class BeastWebSocket final : public WebSocket {
 public:
  explicit BeastWebSocket(std::shared_ptr<Stream> stream) : stream_(std::move(stream)) {}
  ~BeastWebSocket() override { stream_->drop(); }
  void start(WebSocketEvents& events) override { stream_->start(events); }
  void send_text(std::shared_ptr<const std::string> text) override { stream_->send(std::move(text)); }
  void send_binary(SharedBytes bytes) override { stream_->send(std::move(bytes)); }
  std::size_t messages_in_flight() const override { return stream_->messages_in_flight(); }
  void close(std::string reason) override { stream_->close(std::move(reason)); }
  const std::string& peer() const override { return stream_->peer(); }

 private:
  std::shared_ptr<Stream> stream_;
};

}  // namespace

void accept_websocket(beast::tcp_stream stream, const beast::http::request<beast::http::empty_body>& request,
                      std::string peer, std::function<void(std::unique_ptr<WebSocket>)> done) {
  beast::get_lowest_layer(stream).expires_never();  // the socket has its own timeouts
  auto made = std::make_shared<Stream>(std::move(stream), std::move(peer));
  made->accept(request, [done = std::move(done)](const std::shared_ptr<Stream>& ready) {
    done(std::make_unique<BeastWebSocket>(ready));
  });
}

}  // namespace playhouse::net
