#pragma once

/// A small HTTP/1.1 server for GET and HEAD, with upgrade to WebSockets (Network::listen_http).
/// Application-agnostic: a service answers each request synchronously from memory. Limits: limits::kHttp*. Io thread only.

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/base/limits.h"
#include "playhouse/net/websocket.h"

namespace playhouse::net {

struct HttpRequest {
  std::string path;    // not percent-decoded; without the query
  std::string query;   // raw text after the ?
  std::string host;    // Host header, with port
  std::string origin;  // Origin header; empty if absent (not a browser, or same origin)
  std::string if_none_match;
  bool accepts_gzip = false;
  bool encrypted = false;     // by TLS that ends here
  std::string peer;           // "address:port"
  std::string forwarded_for;  // X-Forwarded-For headers, joined by commas; from anybody
};

struct HttpReply {
  unsigned status = 200;
  std::string_view content_type = "text/plain; charset=utf-8";
  std::string_view content_encoding;  // e.g. "gzip"; empty: none
  std::string_view etag;              // quoted; empty: none
  std::string_view cache_control = "no-cache";
  bool varies = false;  // Vary: Accept-Encoding
  /// CSP and frame-ancestors of pages; other responses may load nothing.
  std::string_view content_security_policy = "default-src 'none'; frame-ancestors 'none'";
  std::shared_ptr<const std::string> text;  // the body, or
  std::string_view constant;                // or a body of static lifetime
};

/// Timeouts of a connection.
struct HttpDeadlines {
  std::chrono::milliseconds idle = std::chrono::seconds(limits::kHttpIdleSeconds);
  std::chrono::milliseconds head = std::chrono::seconds(limits::kHttpHeadSeconds);
  std::chrono::milliseconds answer = std::chrono::seconds(limits::kHttpAnswerSeconds);
};

class IoLoop;

/// Where a WebSocket goes on that does not belong to the loop that read its request.
struct OtherLoop {
  IoLoop& loop;
  std::function<void(std::unique_ptr<WebSocket>)> came;  // on that loop's thread, instead of upgraded()
};

class HttpService {
 public:
  virtual ~HttpService() = default;
  /// Whether this host ("name" or "name:port" from the Host header; empty with HTTP/1.0)
  /// is ours. Called first for every request; an error is sent with status 421.
  virtual Result<void> serves(const std::string& host) = 0;
  /// The client behind a reverse proxy, which is then the request's peer and its WebSocket's; an error is
  /// sent with status 400. Called second.
  virtual Result<std::string> client_of(const HttpRequest& request) { return request.peer; }
  virtual HttpReply get(const HttpRequest& request) = 0;
  /// Called before an upgrade to a WebSocket; an error is sent with status 403.
  virtual Result<void> may_upgrade(const HttpRequest& request) = 0;
  /// False: whoever takes the WebSocket limits their number; it takes no slot of the connections here, which viewers
  /// alone must not fill (limits::kViewers). One that goes on elsewhere takes none either.
  virtual bool takes_slot(const HttpRequest&) { return true; }
  /// None: it goes on here. Both loops must end before the service does.
  virtual std::optional<OtherLoop> other_loop(const HttpRequest&) { return std::nullopt; }
  virtual void upgraded(std::unique_ptr<WebSocket> socket, const HttpRequest& request) = 0;
  virtual HttpDeadlines deadlines() const { return {}; }
};

}  // namespace playhouse::net
