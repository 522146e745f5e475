#pragma once

/// Search paths for files named in a world or configuration file: includes, bitmaps, meshes.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/config/text/source_text.h"

namespace playhouse::config {

/// The folders to search, without duplicates, in order: that of the
/// top-level file, that of the referring file, the reader's search path.
std::vector<std::string> folders_for(const std::string& top_level, const std::string& named_by,
                                     const FileReader& files);

/// The absolute path of a file, without the symbolic links and ".." of its folders; the file's own name
/// stays.
std::filesystem::path physical_path(const std::filesystem::path& file);

/// The path of `file` from the folder of `beside`: as both are named, if that leads to the file, else by the
/// folders that their symbolic links lead to.
std::filesystem::path path_from(const std::filesystem::path& beside, const std::filesystem::path& file);

/// Suffix of an error about `name` missing in the first folder: the other
/// folders, and the most similar file name in any of them that `fits`; of an absolute path, the folder where
/// its last part is.
std::string also_not_in(const std::vector<std::string>& folders, std::string_view name,
                        const FileReader& files, const std::function<bool(std::string_view)>& fits);

struct FoundFile {
  std::string path;
  std::optional<std::string> bytes;  // none if already loaded
  std::size_t folder = 0;            // index of the folder
};

/// The first file `name` in these folders that is loaded already or readable. Fails with
/// the path in the first folder, the reason, and the most similar name that `fits`.
Result<FoundFile> find_file(const std::vector<std::string>& folders, std::string_view name, FileReader& files,
                            const std::function<bool(const std::string&)>& is_known,
                            const std::function<bool(std::string_view)>& fits);

}  // namespace playhouse::config
