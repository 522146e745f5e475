#include "playhouse/net/tls/tls_trust.h"

#include <openssl/ssl.h>

#include <string>
#include <utility>

#include "playhouse/net/asio.h"
#include "playhouse/net/tls/asio_tls.h"

namespace playhouse::net {

TlsTrust::TlsTrust(std::unique_ptr<OpenSslTrust> openssl) : openssl_(std::move(openssl)) {}
TlsTrust::~TlsTrust() = default;

Result<std::shared_ptr<TlsTrust>> TlsTrust::of(const Pem& certificates) {
  auto openssl = std::make_unique<OpenSslTrust>();
  asio::ssl::context& context = openssl->context;
  error_code error;
  SSL_CTX_set_min_proto_version(context.native_handle(), TLS1_2_VERSION);
  context.set_verify_mode(asio::ssl::verify_peer, error);
  if (context.add_certificate_authority(asio::buffer(certificates.text), error))
    return Error{certificates.file, "invalid certificate (" + error.message() + "): PEM is valid"};
  return std::make_shared<TlsTrust>(std::move(openssl));
}

}  // namespace playhouse::net
