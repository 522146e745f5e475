#pragma once

/// Accepting sockets, for the .cc files of net only: TCP sessions and HTTP share it.

#include <boost/asio/ip/tcp.hpp>
#include <functional>
#include <memory>
#include <string>

#include "playhouse/net/asio_loop.h"

namespace playhouse::net {

/// A socket that connected, without Nagle delay and with keep-alive for lost peers, and its "address:port".
using SocketAcceptor = std::function<void(boost::asio::ip::tcp::socket, std::string peer)>;

/// Makes a socket so.
void tune(boost::asio::ip::tcp::socket& socket);
/// "address:port", of IPv6 with brackets.
std::string endpoint_text(const boost::asio::ip::tcp::endpoint& endpoint);

/// Accepts on bind:port (as Network::listen) for as long as the Listener lives.
Result<std::unique_ptr<Listener>> listen_tcp(IoLoop::Impl& impl, const std::string& bind, std::uint16_t port,
                                             SocketAcceptor acceptor);

}  // namespace playhouse::net
