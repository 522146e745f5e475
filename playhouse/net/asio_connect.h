#pragma once

/// Sockets that connect, for the .cc files of net only.

#include <boost/asio/ip/tcp.hpp>
#include <functional>
#include <memory>
#include <string>

#include "playhouse/net/asio_loop.h"

namespace playhouse::net {

/// A socket that connected, tuned as those that are accepted, and its "address:port"; or why there is none.
struct ConnectedSocket {
  boost::asio::ip::tcp::socket socket;
  std::string peer;
};
using SocketConnected = std::function<void(Result<ConnectedSocket>)>;

/// As Network::connect.
std::unique_ptr<Attempt> connect_tcp(IoLoop::Impl& impl, const std::string& host, std::uint16_t port,
                                     SocketConnected connected);

}  // namespace playhouse::net
