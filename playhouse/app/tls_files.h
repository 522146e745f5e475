#pragma once

#include <memory>

#include "playhouse/app/commands/options.h"
#include "playhouse/base/result.h"
#include "playhouse/net/tls/tls_identity.h"

namespace playhouse::app {

/// Reads --tls-cert and --tls-key; null without them. Errors name the file.
Result<std::shared_ptr<net::TlsIdentity>> read_tls_files(const Serving& serving);

}  // namespace playhouse::app
