#pragma once

#include <string>
#include <vector>

namespace playhouse {

/// The folders that an environment variable lists, between colons; empty ones are left out, and where it is
/// not set there are none.
std::vector<std::string> folders_of(const char* variable);

}  // namespace playhouse
