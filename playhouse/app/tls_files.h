#pragma once

#include <memory>
#include <string>

#include "playhouse/app/commands/options.h"
#include "playhouse/base/result.h"
#include "playhouse/net/tls/tls_identity.h"
#include "playhouse/net/tls/tls_trust.h"

namespace playhouse::app {

/// Reads --tls-cert and --tls-key; null without them. Errors name the file.
Result<std::shared_ptr<net::TlsIdentity>> read_tls_files(const Serving& serving);

/// Reads --tls-ca; null without a file. Errors name it.
Result<std::shared_ptr<net::TlsTrust>> read_tls_trust(const std::string& file);

}  // namespace playhouse::app
