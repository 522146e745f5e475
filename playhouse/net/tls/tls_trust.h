#pragma once

/// Whom a client of TLS 1.2 or 1.3 trusts, by OpenSSL.

#include <memory>

#include "playhouse/base/result.h"
#include "playhouse/net/tls/tls_identity.h"

namespace playhouse::net {

class TlsTrust {
 public:
  /// Trusts servers with a certificate by one of these authorities, or with one of these that signs itself.
  static Result<std::shared_ptr<TlsTrust>> of(const Pem& certificates);

  struct OpenSslTrust;  // defined in asio_tls.h
  explicit TlsTrust(std::unique_ptr<OpenSslTrust> openssl);
  ~TlsTrust();
  OpenSslTrust& openssl() { return *openssl_; }

 private:
  std::unique_ptr<OpenSslTrust> openssl_;
};

}  // namespace playhouse::net
