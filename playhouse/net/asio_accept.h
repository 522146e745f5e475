#pragma once

/// Accepting sockets; internal to net: shared by TCP sessions and HTTP.

#include <functional>
#include <memory>
#include <string>

#include "playhouse/net/asio.h"
#include "playhouse/net/asio_loop.h"

namespace playhouse::net {

/// A connected socket, not blocking, and with TCP_NODELAY and keep-alive on the line to the peer.
struct AcceptedSocket {
  asio::ip::tcp::socket socket;
  std::string peer;                    // "address:port"
  std::function<void()> expect_alive;  // Connection::expect_alive(); empty: the socket is that line
  bool encrypted = false;              // on that line, by TLS
};
using SocketAcceptor = std::function<void(AcceptedSocket)>;

/// Sets these options on a socket.
void tune(asio::ip::tcp::socket& socket);
/// Connection::expect_alive() of the line to the peer.
void expect_alive(asio::ip::tcp::socket& socket);
/// After an event of tcp::socket::wait_error. True for an error, which remains for the reader; false for urgent data.
bool has_fault(asio::ip::tcp::socket& socket);
/// "address:port", IPv6 addresses in brackets.
std::string endpoint_text(const asio::ip::tcp::endpoint& endpoint);

/// Accepts on bind:port (see Network::listen) during the Listener's lifetime.
Result<std::unique_ptr<Listener>> listen_tcp(IoLoop::Impl& impl, const std::string& bind, std::uint16_t port,
                                             SocketAcceptor acceptor);

}  // namespace playhouse::net
