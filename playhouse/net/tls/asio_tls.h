#pragma once

/// OpenSSL's side of TLS; internal to net.

#include <boost/asio/ssl/context.hpp>

#include "playhouse/net/tls/tls_identity.h"
#include "playhouse/net/tls/tls_trust.h"

namespace playhouse::net {

struct TlsIdentity::OpenSsl {
  boost::asio::ssl::context context{boost::asio::ssl::context::tls_server};
};

struct TlsTrust::OpenSslTrust {
  boost::asio::ssl::context context{boost::asio::ssl::context::tls_client};
};

}  // namespace playhouse::net
