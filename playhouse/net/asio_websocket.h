#pragma once

/// Hand-over of a connection from http.cc to websocket.cc; internal to net.

#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <functional>
#include <memory>
#include <string>

#include "playhouse/net/http_places.h"
#include "playhouse/net/websocket.h"

namespace playhouse::net {

/// Performs the handshake and calls `done` with the socket; on failure the connection is just
/// closed. The socket keeps its place until it is closed, evictable during handshake and closing; null: it has
/// none.
void accept_websocket(boost::beast::tcp_stream stream,
                      const boost::beast::http::request<boost::beast::http::empty_body>& request,
                      std::string peer, std::unique_ptr<HttpPlace> place,
                      std::function<void(std::unique_ptr<WebSocket>)> done);

}  // namespace playhouse::net
