#pragma once

/// TLS in front of connections; internal to net. A build without OpenSSL has without/without_tls.cc instead.

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "playhouse/net/asio.h"
#include "playhouse/net/asio_loop.h"
#include "playhouse/net/tls/tls_identity.h"
#include "playhouse/net/tls/tls_trust.h"

namespace playhouse::net {

/// A socket with what the peer says, decrypted; what is written to it goes to the peer, encrypted. It ends when the peer's
/// connection ends, and the reverse.
struct Decrypted {
  asio::ip::tcp::socket socket;
  std::function<void()> expect_alive;  // Connection::expect_alive() of the peer's connection
};

inline constexpr int kHandshakeSeconds = 10;
inline constexpr std::size_t kHandshakes = 256;  // at once: over it the oldest is given up

/// Performs the handshake of a server. The connection is closed, and `done` gets the reason, if it fails or takes
/// longer.
void decrypt(IoLoop::Impl& loop, std::shared_ptr<TlsIdentity> identity, asio::ip::tcp::socket socket,
             std::function<void(Result<Decrypted>)> done);
/// The same of a client, which fails as well unless the server's certificate is for `host` and is trusted.
void decrypt_from(IoLoop::Impl& loop, std::shared_ptr<TlsTrust> trust, const std::string& host,
                  asio::ip::tcp::socket socket, std::function<void(Result<Decrypted>)> done);

}  // namespace playhouse::net
