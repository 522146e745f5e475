#pragma once

/// Nothing that is read is written over: an option that writes a file may name a world, a bitmap or a saved
/// run by mistake.

#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/scene/source_text.h"

namespace playhouse::app {

/// Fails if writing `output` would change a file of `read`, by whatever name. An empty output is none.
Result<void> keep_files(const std::string& output, std::span<const std::string> read);

/// The files of a scene.
std::vector<std::string> names_of(const scene::SourceFiles& sources);

}  // namespace playhouse::app
