#pragma once

namespace playhouse::app {

/// Lets this process open as many files and sockets as the system allows it: a server of many clients needs
/// more than the usual 1,024.
void raise_descriptor_limit();

}  // namespace playhouse::app
