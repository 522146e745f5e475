#pragma once

/// A small HTTP/1.1 server for GET and HEAD, and the door to WebSockets. Knows neither files nor viewers: a
/// service answers each request at once from memory. Limits: limits::kHttp*. Everything is for the io thread.

#include <memory>
#include <string>
#include <string_view>

#include "playhouse/net/io_loop.h"
#include "playhouse/net/websocket.h"

namespace playhouse::net {

struct HttpRequest {
  std::string path;    // decoded nowhere: as the client wrote it, without the query
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
  std::shared_ptr<const std::string> text;  // the body, or
  std::string_view constant;                // a body that outlives the server
};

class HttpService {
 public:
  virtual ~HttpService() = default;
  virtual HttpReply get(const HttpRequest& request) = 0;
  /// Asked before a WebSocket is made of a connection; an error is answered with 403 and its text.
  virtual Result<void> may_upgrade(const HttpRequest& request) = 0;
  virtual void upgraded(std::unique_ptr<WebSocket> socket, const HttpRequest& request) = 0;
};

/// Serves on bind:port (0: any free one) for as long as the Listener lives. The service outlives the loop's
/// run.
Result<std::unique_ptr<Listener>> listen_http(IoLoop& loop, const std::string& bind, std::uint16_t port,
                                              HttpService& service);

}  // namespace playhouse::net
