#pragma once

#include <cstddef>

namespace playhouse::device_server {

/// Raises the soft limit on open files to the hard limit: a
/// server of many clients needs more than the usual 1,024.
void raise_descriptor_limit();

/// How many Player clients may be connected so that pages, files and what is open already have descriptors
/// left; limits::kSessions where the limit on open files allows it. Logs fewer than 4096. `encrypted`: by TLS.
std::size_t sessions_that_fit(bool encrypted);

}  // namespace playhouse::device_server
