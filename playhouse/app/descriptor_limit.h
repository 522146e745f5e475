#pragma once

namespace playhouse::app {

/// Raises the soft limit on open files to the hard limit: a
/// server of many clients needs more than the usual 1,024.
void raise_descriptor_limit();

}  // namespace playhouse::app
