#pragma once

/// Player's byte stream over a WebSocket, for clients in browsers: binary messages,
/// which may cut the stream anywhere. The banner and all frames are those of TCP.

#include <cstdint>
#include <memory>

#include "playhouse/net/websocket.h"
#include "playhouse/server/server.h"

namespace playhouse::server {

/// The connection owns the socket. Text messages and those over limits::kSocketMessageBytes close it.
std::unique_ptr<net::Connection> websocket_connection(std::unique_ptr<net::WebSocket> socket);

/// Serves the client at this port; closes the socket with a reason if the server has no such port.
void accept_websocket(Server& server, std::uint16_t port, std::unique_ptr<net::WebSocket> socket);

}  // namespace playhouse::server
