#pragma once

/// Where a file is looked for that a file of a scene names: an include, a bitmap.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/source_text.h"

namespace playhouse::scene {

/// The folders to look in, each once, in their order: that of the top-level file, that of the file that names
/// it, the reader's search path.
std::vector<std::string> folders_for(const std::string& top_level, const std::string& named_by,
                                     const FileReader& files);

/// The tail of an error that tells of `name` in the first of these folders: the others, and the nearest name
/// of a file in any of them that `fits`.
std::string also_not_in(const std::vector<std::string>& folders, std::string_view name,
                        const FileReader& files, const std::function<bool(std::string_view)>& fits);

}  // namespace playhouse::scene
