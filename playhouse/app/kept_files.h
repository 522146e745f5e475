#pragma once

/// Protection of input files from being overwritten: an output
/// option may name a world, a bitmap or a saved run by mistake.

#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/text/source_text.h"

namespace playhouse::app {

/// Fails if `output` is the same file as one in `read`, under any name. An empty output is fine.
Result<void> keep_files(const std::string& output, std::span<const std::string> read);

/// The files of a scene.
std::vector<std::string> names_of(const config::SourceFiles& sources);

}  // namespace playhouse::app
