#include "playhouse/net/http.h"

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <optional>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/net/asio_accept.h"
#include "playhouse/net/asio_websocket.h"

namespace playhouse::net {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using beast::error_code;
using Request = http::request<http::empty_body>;
using Response = http::response<http::span_body<const char>>;

std::string text_of(beast::string_view text) {
  return {text.data(), text.size()};
}

HttpRequest request_of(const Request& from, const std::string& peer) {
  HttpRequest request;
  request.path = text_of(from.target().substr(0, from.target().find('?')));
  request.host = text_of(from[http::field::host]);
  request.origin = text_of(from[http::field::origin]);
  request.if_none_match = text_of(from[http::field::if_none_match]);
  request.accepts_gzip = http::token_list(from[http::field::accept_encoding]).exists("gzip");
  request.peer = peer;
  return request;
}

HttpReply plain(unsigned status, std::string text) {
  HttpReply reply;
  reply.status = status;
  reply.text = std::make_shared<const std::string>(std::move(text) + "\n");
  return reply;
}

/// One connection, kept alive by its own operations until it ends or is silent for too long.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(asio::ip::tcp::socket socket, std::string peer, HttpService& service,
                 std::shared_ptr<int> place)
      : stream_(std::move(socket)), peer_(std::move(peer)), service_(service), place_(std::move(place)) {}

  void read() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(limits::kHttpHeaderBytes));
    parser_->body_limit(0);
    stream_.expires_after(std::chrono::seconds(limits::kHttpIdleSeconds));
    http::async_read(
        stream_, buffer_, *parser_,
        [self = shared_from_this()](const error_code& error, std::size_t) { self->read_done(error); });
  }

 private:
  void read_done(const error_code& error) {
    if (error == http::error::body_limit) return answer(plain(413, "a request here has no body"), false);
    if (error == http::error::header_limit)
      return answer(plain(431, "the request's header is too long"), false);
    if (error.category() == http::make_error_code(http::error::end_of_stream).category() &&
        error != http::error::end_of_stream && error != http::error::partial_message) {
      return answer(plain(400, "not an HTTP request"), false);
    }
    if (error) return close();
    const Request& message = parser_->get();
    const HttpRequest request = request_of(message, peer_);
    if (beast::websocket::is_upgrade(message)) return upgrade(request);
    if (message.method() != http::verb::get && message.method() != http::verb::head) {
      return answer(plain(405, "only GET and HEAD are served here"), false);
    }
    HttpReply reply = service_.get(request);
    if (reply.status == 200 && !reply.etag.empty() && request.if_none_match == reply.etag) reply.status = 304;
    answer(std::move(reply), message.keep_alive());
  }

  void upgrade(const HttpRequest& request) {
    if (const Result<void> allowed = service_.may_upgrade(request); !allowed) {
      return answer(plain(403, allowed.error().line()), false);
    }
    accept_websocket(std::move(stream_), parser_->get(), peer_,
                     [&service = service_, request](std::unique_ptr<WebSocket> socket) {
                       service.upgraded(std::move(socket), request);
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
    response_->set("X-Content-Type-Options", "nosniff");
    if (!reply_.etag.empty()) response_->set(http::field::etag, sv(reply_.etag));
    if (!reply_.content_encoding.empty())
      response_->set(http::field::content_encoding, sv(reply_.content_encoding));
    if (reply_.status == 405) response_->set(http::field::allow, "GET, HEAD");
    if (reply_.status != 304) response_->content_length(body.size());
    if (with_body) response_->body() = beast::span<const char>(body.data(), body.size());
    stream_.expires_after(std::chrono::seconds(limits::kHttpIdleSeconds));
    serializer_.emplace(*response_);
    http::async_write(stream_, *serializer_,
                      [self = shared_from_this(), keep_alive](const error_code& error, std::size_t) {
                        if (error || !keep_alive) return self->close();
                        self->read();
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
  HttpService& service_;
  std::shared_ptr<int> place_;  // counts the open connections
  beast::flat_buffer buffer_{limits::kHttpHeaderBytes + 4096};
  std::optional<http::request_parser<http::empty_body>> parser_;
  HttpReply reply_;
  std::optional<Response> response_;
  std::optional<http::response_serializer<http::span_body<const char>>> serializer_;
};

}  // namespace

Result<std::unique_ptr<Listener>> listen_http(IoLoop& loop, const std::string& bind, std::uint16_t port,
                                              HttpService& service) {
  // The listener and each connection own the counter; a connection over the limit is closed at once, and told
  // when it begins: a flood of connections must not become one of log lines.
  auto places = std::make_shared<int>(0);
  return listen_tcp(
      loop.impl(), bind, port,
      [&service, places, full = false](asio::ip::tcp::socket socket, std::string peer) mutable {
        if (static_cast<std::size_t>(places.use_count()) > limits::kHttpConnections) {
          if (!std::exchange(full, true))
            log::warn("web: {} turned away, {} connections are open", peer, limits::kHttpConnections);
          return;
        }
        full = false;
        std::make_shared<HttpConnection>(std::move(socket), std::move(peer), service, places)->read();
      });
}

}  // namespace playhouse::net
