#pragma once

/// How http.cc hands a connection over to websocket.cc; for the .cc files of net only.

#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <functional>
#include <memory>
#include <string>

#include "playhouse/net/http_places.h"
#include "playhouse/net/websocket.h"

namespace playhouse::net {

/// Answers the upgrade request and calls `done` with the socket; a failed handshake just ends the connection.
/// The socket holds the place until it is closed: through the handshake and while it closes it gives way.
void accept_websocket(boost::beast::tcp_stream stream,
                      const boost::beast::http::request<boost::beast::http::empty_body>& request,
                      std::string peer, std::unique_ptr<HttpPlace> place,
                      std::function<void(std::unique_ptr<WebSocket>)> done);

}  // namespace playhouse::net
