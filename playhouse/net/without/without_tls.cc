/// What takes the place of TLS, pages and WebSockets in a build without Boost and OpenSSL: nobody has an identity or an authority, so
/// no port speaks TLS.

#include "playhouse/base/assert.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/tls/decrypt.h"

namespace playhouse::net {

struct TlsIdentity::OpenSsl {};
struct TlsTrust::OpenSslTrust {};

TlsIdentity::TlsIdentity(std::unique_ptr<OpenSsl> openssl) : openssl_(std::move(openssl)) {}
TlsIdentity::~TlsIdentity() = default;
TlsTrust::TlsTrust(std::unique_ptr<OpenSslTrust> openssl) : openssl_(std::move(openssl)) {}
TlsTrust::~TlsTrust() = default;

Result<std::shared_ptr<TlsIdentity>> TlsIdentity::of(const Pem& certificates, const Pem&) {
  return Error{certificates.file, "this program was built without TLS"};
}

Result<std::shared_ptr<TlsTrust>> TlsTrust::of(const Pem& certificates) {
  return Error{certificates.file, "this program was built without TLS"};
}

void decrypt(IoLoop::Impl&, std::shared_ptr<TlsIdentity>, asio::ip::tcp::socket,
             std::function<void(Result<Decrypted>)>) {
  PLAYHOUSE_ASSERT(false);  // there is no identity
}

void decrypt_from(IoLoop::Impl&, std::shared_ptr<TlsTrust>, const std::string&, asio::ip::tcp::socket,
                  std::function<void(Result<Decrypted>)>) {
  PLAYHOUSE_ASSERT(false);  // there is no authority
}

Result<std::unique_ptr<Listener>> IoLoop::listen_http(const std::string& bind, std::uint16_t, HttpService&) {
  return Error{bind, "this program was built without pages"};
}

}  // namespace playhouse::net
