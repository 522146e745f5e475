#pragma once

/// Where a file is looked for that a file of a scene names: an include, a bitmap, a mesh.

#include <functional>
#include <optional>
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

struct FoundFile {
  std::string path;
  std::optional<std::string> bytes;  // none of one that is known
  std::size_t folder = 0;            // in which it was
};

/// The first file `name` in these folders that is known or can be read. Fails with the path in the first
/// folder and why it is not there, and with the nearest name that `fits`.
Result<FoundFile> find_file(const std::vector<std::string>& folders, std::string_view name, FileReader& files,
                            const std::function<bool(const std::string&)>& is_known,
                            const std::function<bool(std::string_view)>& fits);

}  // namespace playhouse::scene
