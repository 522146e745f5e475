#pragma once

/// A small HTTP/1.1 server for GET and HEAD, and the door to WebSockets. Knows neither files nor viewers: a
/// service answers each request at once from memory. Limits: limits::kHttp*. Everything is for the io thread.

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "playhouse/base/limits.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/websocket.h"

namespace playhouse::net {

struct HttpRequest {
  std::string path;    // not percent-decoded; without the query
  std::string query;   // what is behind the ?, as the client wrote it
  std::string host;    // of the Host header, with the port
  std::string origin;  // of the Origin header; empty when there is none (not a browser, or the same site)
  std::string if_none_match;
  bool accepts_gzip = false;
  std::string peer;  // "address:port"
};

struct HttpReply {
  unsigned status = 200;
  std::string_view content_type = "text/plain; charset=utf-8";
  std::string_view content_encoding;  // e.g. "gzip"; empty: none
  std::string_view etag;              // quoted; empty: none
  std::string_view cache_control = "no-cache";
  bool varies = false;  // with what encodings the client accepts
  /// What a page may load and who may show it in a frame; non-page responses may load nothing.
  std::string_view content_security_policy = "default-src 'none'; frame-ancestors 'none'";
  std::shared_ptr<const std::string> text;  // the body, or
  std::string_view constant;                // a body that outlives the server
};

class HttpService {
 public:
  virtual ~HttpService() = default;
  /// Whether requests for this host ("name" or "name:port", as the browser calls us; empty: HTTP/1.0 names
  /// none) are for us. Asked first, of every request; an error is answered with 421 and its text.
  virtual Result<void> serves(const std::string& host) = 0;
  virtual HttpReply get(const HttpRequest& request) = 0;
  /// Asked before a WebSocket is made of a connection; an error is answered with 403 and its text.
  virtual Result<void> may_upgrade(const HttpRequest& request) = 0;
  virtual void upgraded(std::unique_ptr<WebSocket> socket, const HttpRequest& request) = 0;
};

/// How long a connection may wait for its peer.
struct HttpDeadlines {
  std::chrono::milliseconds idle = std::chrono::seconds(limits::kHttpIdleSeconds);
  std::chrono::milliseconds head = std::chrono::seconds(limits::kHttpHeadSeconds);
  std::chrono::milliseconds answer = std::chrono::seconds(limits::kHttpAnswerSeconds);
};

/// Serves on bind:port (0: any free one) for as long as the Listener lives. The service outlives the loop's
/// run.
Result<std::unique_ptr<Listener>> listen_http(IoLoop& loop, const std::string& bind, std::uint16_t port,
                                              HttpService& service, HttpDeadlines deadlines = {});

}  // namespace playhouse::net
