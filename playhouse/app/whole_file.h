#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/config/text/source_text.h"

namespace playhouse::app {

/// Reads a whole file of `most` bytes at most: a regular one, or a pipe if a person named it, never a device
/// without end. Errors include its name.
Result<std::string> read_file(const std::string& path, config::NamedBy by = config::NamedBy::kPerson,
                              std::size_t most = limits::kFileBytes);

/// Fails, as a later write would, if the name is a folder's or no file can be created in its folder.
Result<void> check_writable(const std::string& path);

/// Writes a file atomically: concurrent readers, and readers after
/// a failure, see the old contents. Errors include its name.
Result<void> write_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace playhouse::app
