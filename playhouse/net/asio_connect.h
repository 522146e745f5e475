#pragma once

/// Connecting sockets; internal to net.

#include <functional>
#include <memory>
#include <string>

#include "playhouse/net/asio.h"
#include "playhouse/net/asio_loop.h"

namespace playhouse::net {

/// A connected socket, with the options of accepted ones, and its "address:port"; or an error.
struct ConnectedSocket {
  asio::ip::tcp::socket socket;
  std::string peer;
};
using SocketConnected = std::function<void(Result<ConnectedSocket>)>;

/// See Network::connect.
std::unique_ptr<Attempt> connect_tcp(IoLoop::Impl& impl, const std::string& host, std::uint16_t port,
                                     SocketConnected connected);

}  // namespace playhouse::net
