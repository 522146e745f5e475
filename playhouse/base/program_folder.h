#pragma once

#include <filesystem>

namespace playhouse {

/// The folder of the running executable, through symbolic links; empty if the system does not tell.
std::filesystem::path program_folder();

}  // namespace playhouse
