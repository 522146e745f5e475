#include "playhouse/net/tls/tls_identity.h"

#include <openssl/ssl.h>

#include <cstddef>
#include <utility>

#include "playhouse/net/asio.h"
#include "playhouse/net/tls/asio_tls.h"

namespace playhouse::net {
namespace {

constexpr const char* kValidCertificate = "PEM, beginning with the certificate of the server, is valid";
constexpr const char* kValidKey = "that of the certificate, PEM, without a passphrase, is valid";

Error invalid(const std::string& file, const char* what, const error_code& error, const char* valid) {
  return {file, std::string("invalid ") + what + " (" + error.message() + "): " + valid};
}

}  // namespace

TlsIdentity::TlsIdentity(std::unique_ptr<OpenSsl> openssl) : openssl_(std::move(openssl)) {}
TlsIdentity::~TlsIdentity() = default;

Result<std::shared_ptr<TlsIdentity>> TlsIdentity::of(const Pem& certificates, const Pem& key) {
  auto openssl = std::make_unique<OpenSsl>();
  asio::ssl::context& context = openssl->context;
  error_code error;
  // Without a callback OpenSSL would ask the terminal.
  context.set_password_callback([](std::size_t, asio::ssl::context::password_purpose) { return ""; }, error);
  SSL_CTX_set_min_proto_version(context.native_handle(), TLS1_2_VERSION);
  SSL_CTX_set_options(context.native_handle(), SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION);
  if (context.use_certificate_chain(asio::buffer(certificates.text), error))
    return invalid(certificates.file, "certificate", error, kValidCertificate);
  if (context.use_private_key(asio::buffer(key.text), asio::ssl::context::pem, error))
    return invalid(key.file, "private key", error, kValidKey);
  if (SSL_CTX_check_private_key(context.native_handle()) != 1)
    return Error{key.file, std::string("invalid private key: ") + kValidKey};
  return std::make_shared<TlsIdentity>(std::move(openssl));
}

}  // namespace playhouse::net
