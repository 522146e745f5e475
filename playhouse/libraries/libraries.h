#pragma once

/// Which shared libraries a world may use, and the one way from a name in a world file to one that is open.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/libraries/shared_library.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::libraries {

/// The libraries that a world may use. A library's code runs with all rights of the program, so a world file
/// cannot have any file of the machine loaded by its path.
struct Libraries {
  enum class Use : std::uint8_t { kLoad, kFind };  // kFind: none is loaded, as a file is only checked

  std::vector<std::filesystem::path> folders;  // where they are looked for by name, in order
  std::vector<std::filesystem::path> allowed;  // outside these folders
  Use use = Use::kLoad;
};

/// Where libraries are looked for: the folder of the world file, those of PLAYHOUSE_PATH and STAGEPATH
/// (separated by colons), and `program_folder`.
std::vector<std::filesystem::path> library_folders(const scene::SceneDesc& scene,
                                                   const std::filesystem::path& program_folder);

/// What a world file asks for.
struct Wanted {
  const Provided& provided;
  std::string name;                             // of the file, with or without ".so"
  std::string where;                            // "file:line"
  std::span<const std::string_view> built_ins;  // names that need no library, for errors
};

/// Opens the library, with a line in the log before; null, with a warning for `warnings`, where none is
/// loaded. Fails with one line if there is none of that name, it may not be used, or it is not what is
/// wanted.
Result<std::shared_ptr<SharedLibrary>> load(const Wanted& wanted, const Libraries& libraries,
                                            std::vector<std::string>& warnings);

/// The words of a text, as they stand between spaces: the name in front, arguments behind it.
std::vector<std::string> words_of(std::string_view text);

}  // namespace playhouse::libraries
