#pragma once

/// The worlds that come with the program, with their robots, bitmaps, meshes and configurations.

#include <filesystem>
#include <string>

#include "playhouse/base/program_folder.h"

namespace playhouse::config {

/// Their folder, with trailing slash, for a program in the folder `program`: that of its installation
/// (cmake/Install.cmake), else `worlds` in a parent folder, as in the source tree; "" if there is neither.
std::string shipped_worlds(const std::filesystem::path& program = program_folder());

/// Suffix of an error about a missing file: the shipped one of the same name, or "".
std::string did_you_mean_shipped(const std::string& path);

}  // namespace playhouse::config
