#pragma once

#include <string>
#include <vector>

namespace playhouse {

/// Splits an environment variable at colons into
/// folders, skipping empty ones; none if it is not set.
std::vector<std::string> folders_of(const char* variable);

}  // namespace playhouse
