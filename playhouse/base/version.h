#pragma once

/// The version of the program and the commit that it was built from, for people, logs and handshakes. Whoever
/// reads a file or a message compares the numbers of formats.h instead, and never anything that is hashed. Any
/// thread.

#include <string_view>

namespace playhouse {

/// "0.2.0"
std::string_view version();
/// "abc1234", "abc1234-dirty" with changes that no commit has, or "unknown".
std::string_view commit();
/// "0.2.0 (abc1234)"
std::string_view build();

}  // namespace playhouse
