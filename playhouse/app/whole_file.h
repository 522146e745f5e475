#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::app {

/// All bytes of a file. The error names it.
Result<std::string> read_file(const std::string& path);

/// Writes a file as a whole: who reads it meanwhile, or after a failure, finds the old one. The error names
/// it.
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace playhouse::app
