#pragma once

/// The server's side of a WebSocket handshake, in a file of its own: Beast's templates for it take the
/// compiler longer than those of reading and writing together. Internal to net.

#include <boost/beast/core/error.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <functional>

namespace playhouse::net {

using WebSocketStream = boost::beast::websocket::stream<boost::beast::tcp_stream>;

/// Answers the request; `done` is called once the stream is open, or with an error. The stream must live
/// until then.
void answer_handshake(WebSocketStream& stream,
                      const boost::beast::http::request<boost::beast::http::empty_body>& request,
                      std::function<void(const boost::beast::error_code&)> done);

}  // namespace playhouse::net
