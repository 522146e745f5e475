#pragma once

/// The process of a plug-in with `isolated 1`: this program, which does nothing but call that plug-in's hooks as the
/// program at the other end of kPluginSocket says. When that one is gone, however it ended, the plug-in's close() is
/// called as at any end of the program, and the process ends.

namespace playhouse::drivers {

/// True if the command line is that of such a process. For main(), before anything else.
bool is_isolated_plugin(int argc, const char* const* argv);

/// Returns only where nobody is at the other end, with the exit code.
int run_isolated_plugin();

}  // namespace playhouse::drivers
