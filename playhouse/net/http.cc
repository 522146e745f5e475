#include "playhouse/net/http.h"

#include <unistd.h>

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <optional>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/net/asio.h"
#include "playhouse/net/asio_accept.h"
#include "playhouse/net/asio_http.h"
#include "playhouse/net/asio_websocket.h"
#include "playhouse/net/http_places.h"
#include "playhouse/net/http_request.h"
#include "playhouse/net/io_loop.h"

namespace playhouse::net {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using Response = http::response<http::span_body<const char>>;

constexpr std::chrono::seconds kLingerTime{2};  // of reading on behind the last answer, so that it arrives

/// Security headers of every reply: no MIME sniffing, no referrer, no embedding.
constexpr std::pair<const char*, const char*> kFixedFields[] = {
    {"X-Content-Type-Options", "nosniff"},
    {"X-Frame-Options", "DENY"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Referrer-Policy", "no-referrer"}};

HttpReply plain(unsigned status, std::string text) {
  HttpReply reply;
  reply.status = status;
  reply.text = std::make_shared<const std::string>(std::move(text) + "\n");
  return reply;
}

/// A connection, kept alive by its pending operations until it ends or times out.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(AcceptedSocket accepted, HttpService& service, const HttpDeadlines& deadlines,
                 std::unique_ptr<HttpPlace> place)
      : stream_(std::move(accepted.socket)),
        peer_(std::move(accepted.peer)),
        encrypted_(accepted.encrypted),
        service_(service),
        deadlines_(deadlines),
        place_(std::move(place)) {}

  /// Waits for the next request.
  void start() {
    if (buffer_.size() > 0) return read();
    wait(deadlines_.idle);
    stream_.async_read_some(buffer_.prepare(limits::kHttpHeaderBytes),
                            [self = shared_from_this()](const error_code& error, std::size_t count) {
                              if (error) return self->close();
                              self->buffer_.commit(count);
                              self->read();
                            });
  }

 private:
  /// Sets the timeout for the peer, and makes the connection evictable.
  void wait(std::chrono::milliseconds time) {
    stream_.expires_after(time);
    place_->gives_way([this] { close(); });
  }

  void read() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(limits::kHttpHeaderBytes));
    parser_->body_limit(0);
    wait(deadlines_.head);
    http::async_read_header(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](const error_code& error, std::size_t) { self->read_done(error); });
  }

  void read_done(const error_code& error) {
    if (error) {
      const std::optional<HttpRefusal> refusal = refusal_of(error);
      return refusal ? refuse(*refusal) : close();
    }
    auto request = read_request(parser_->get(), peer_);
    if (const auto* refusal = std::get_if<HttpRefusal>(&request)) return refuse(*refusal);
    serve(std::get<HttpRequest>(request));
  }

  void serve(HttpRequest& request) {
    request.encrypted = encrypted_;
    if (const Result<void> ours = service_.serves(request.host); !ours)
      return refuse({421, ours.error().line()});
    Result<std::string> client = service_.client_of(request);
    if (!client) return refuse({400, client.error().line()});
    request.peer = std::move(*client);
    if (beast::websocket::is_upgrade(parser_->get())) return upgrade(request);
    HttpReply reply = service_.get(request);
    if (reply.status == 200 && !reply.etag.empty() && request.if_none_match == reply.etag) reply.status = 304;
    answer(std::move(reply), parser_->get().keep_alive());
  }

  void refuse(const HttpRefusal& refusal) { answer(plain(refusal.status, refusal.text), false); }

  void upgrade(const HttpRequest& request) {
    if (const Result<void> allowed = service_.may_upgrade(request); !allowed) {
      return refuse({403, allowed.error().line()});
    }
    if (const std::optional<OtherLoop> other = service_.other_loop(request)) return move_to(*other, request);
    if (!service_.takes_slot(request)) place_.reset();
    accept_websocket(std::move(stream_), parser_->get(), request.peer, std::move(place_),
                     [&service = service_, request](std::unique_ptr<WebSocket> socket) {
                       service.upgraded(std::move(socket), request);
                     });
  }

  /// Handshake and messages are the other loop's.
  void move_to(const OtherLoop& other, const HttpRequest& request) {
    error_code error;
    const auto socket = std::make_shared<asio::ip::tcp::socket>(other.loop.impl().context);
    const int descriptor = stream_.release_socket().release(error);
    place_.reset();
    if (socket->assign(asio::ip::tcp::v4(), descriptor, error)) return static_cast<void>(::close(descriptor));
    other.loop.post([socket, other, request = parser_->get(), peer = request.peer] {
      accept_websocket(beast::tcp_stream(std::move(*socket)), request, peer, nullptr, other.came);
    });
  }

  void answer(HttpReply reply, bool keep_alive) {
    reply_ = std::move(reply);
    const std::string_view body = reply_.text ? std::string_view(*reply_.text) : reply_.constant;
    const bool with_body = reply_.status != 304 && parser_->get().method() != http::verb::head;
    response_.emplace();
    response_->result(reply_.status);
    response_->keep_alive(keep_alive);
    response_->set(http::field::content_type, sv(reply_.content_type));
    response_->set(http::field::cache_control, sv(reply_.cache_control));
    response_->set("Content-Security-Policy", sv(reply_.content_security_policy));
    for (const auto& [name, value] : kFixedFields) response_->set(name, value);
    if (reply_.varies) response_->set(http::field::vary, "Accept-Encoding");
    if (!reply_.etag.empty()) response_->set(http::field::etag, sv(reply_.etag));
    if (!reply_.content_encoding.empty())
      response_->set(http::field::content_encoding, sv(reply_.content_encoding));
    if (reply_.status == 405) response_->set(http::field::allow, "GET, HEAD");
    if (reply_.status != 304) response_->content_length(body.size());
    if (with_body) response_->body() = beast::span<const char>(body.data(), body.size());
    wait(deadlines_.answer);
    serializer_.emplace(*response_);
    http::async_write(stream_, *serializer_,
                      [self = shared_from_this(), keep_alive](const error_code& error, std::size_t) {
                        if (error) return self->close();
                        keep_alive ? self->start() : self->finish();
                      });
  }

  /// Half-closes and drains input to the peer's end: closing with unread input
  /// would send RST, which discards unread parts of the reply at the peer.
  void finish() {
    error_code ignored;
    stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
    wait(kLingerTime);
    discard();
  }

  void discard() {
    buffer_.clear();
    stream_.async_read_some(buffer_.prepare(4096),
                            [self = shared_from_this()](const error_code& error, std::size_t) {
                              error ? self->close() : self->discard();
                            });
  }

  static beast::string_view sv(std::string_view text) { return {text.data(), text.size()}; }

  void close() {
    error_code ignored;
    stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
    stream_.close();
  }

  beast::tcp_stream stream_;
  const std::string peer_;
  const bool encrypted_;
  HttpService& service_;
  const HttpDeadlines deadlines_;
  std::unique_ptr<HttpPlace> place_;  // null once the socket is a WebSocket's
  beast::flat_buffer buffer_{limits::kHttpHeaderBytes + 4096};
  std::optional<http::request_parser<http::empty_body>> parser_;
  HttpReply reply_;
  std::optional<Response> response_;
  std::optional<http::response_serializer<http::span_body<const char>>> serializer_;
};

}  // namespace

void serve_http(AcceptedSocket accepted, HttpService& service, const HttpDeadlines& deadlines,
                const std::shared_ptr<HttpPlaces>& places) {
  auto place = std::make_unique<HttpPlace>(places, accepted.peer);
  std::make_shared<HttpConnection>(std::move(accepted), service, deadlines, std::move(place))->start();
}

Result<std::unique_ptr<Listener>> IoLoop::listen_http(const std::string& bind, std::uint16_t port,
                                                      HttpService& service) {
  // The table of places is owned by the listener and each connection.
  return listen_tcp(*impl_, bind, port,
                    [&service, places = std::make_shared<HttpPlaces>()](AcceptedSocket accepted) {
                      serve_http(std::move(accepted), service, service.deadlines(), places);
                    });
}

}  // namespace playhouse::net
