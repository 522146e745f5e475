#pragma once

/// The certificate and private key of a server that speaks TLS 1.2 or 1.3, by OpenSSL.

#include <memory>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::net {

/// A PEM file.
struct Pem {
  std::string file;  // for errors
  std::string text;
};

class TlsIdentity {
 public:
  /// From the certificate, followed by those of its issuers if there are any, and its private key without a passphrase.
  static Result<std::shared_ptr<TlsIdentity>> of(const Pem& certificates, const Pem& key);

  struct OpenSsl;  // defined in asio_tls.h
  explicit TlsIdentity(std::unique_ptr<OpenSsl> openssl);
  ~TlsIdentity();
  OpenSsl& openssl() { return *openssl_; }

 private:
  std::unique_ptr<OpenSsl> openssl_;
};

}  // namespace playhouse::net
