#pragma once

/// Policy of loading shared libraries, and resolution of names in world files.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/libraries/shared_library.h"

namespace playhouse::libraries {

/// Where a world's libraries may come from. Library code runs with all rights of
/// the program, so a world file must not be able to load arbitrary files by path: a path leads into one of the
/// folders, or below it, or to an allowed file.
struct Libraries {
  enum class LibraryUse : std::uint8_t { kLoad, kFind };  // kFind: located but not loaded, for checks

  std::vector<std::filesystem::path> folders;  // search path for names, in order
  std::vector<std::filesystem::path> allowed;  // allowed files elsewhere, also found by their names alone
  LibraryUse use = LibraryUse::kLoad;
};

/// The search path: the folder of the file that names a library, unless empty, those of PLAYHOUSE_PATH and of
/// the variable of the original, STAGEPATH or PLAYERPATH (colon-separated), and `program_folder`.
std::vector<std::filesystem::path> library_folders(const std::string& of_file, const char* of_original,
                                                   const std::filesystem::path& program_folder);

/// A request of a world file.
struct WantedLibrary {
  const LibraryAbi& provided;
  std::string name;                             // file name, with or without ".so", or a path
  std::string where;                            // "file:line"
  std::span<const std::string_view> built_ins;  // built-in names, for error messages
};

/// Whether there is such a file, be it allowed or not.
bool is_there(const WantedLibrary& wanted, const Libraries& libraries);

/// The file of a library that may be loaded, announced in the log; empty, with a warning in `warnings`, if libraries
/// are only located. Fails with a one-line message if it is not found or not allowed.
Result<std::filesystem::path> locate(const WantedLibrary& wanted, const Libraries& libraries,
                                     std::vector<std::string>& warnings);

/// Loads the library that locate() finds; null if there is none. Fails likewise, and if it is of another kind.
Result<std::shared_ptr<SharedLibrary>> load(const WantedLibrary& wanted, const Libraries& libraries,
                                            std::vector<std::string>& warnings);

/// Splits a text at spaces: the name, then arguments.
std::vector<std::string> words_of(std::string_view text);

}  // namespace playhouse::libraries
