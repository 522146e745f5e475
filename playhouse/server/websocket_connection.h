#pragma once

/// Player's byte stream over a WebSocket, for clients in browsers: binary messages,
/// which may cut the stream anywhere. The banner and all frames are those of TCP.

#include <memory>

#include "playhouse/net/websocket.h"

namespace playhouse::server {

/// The connection owns the socket. Text messages and those over limits::kSocketMessageBytes close it.
std::unique_ptr<net::Connection> websocket_connection(std::unique_ptr<net::WebSocket> socket);

}  // namespace playhouse::server
