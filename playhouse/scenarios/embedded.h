#pragma once

#include <map>
#include <string>

namespace playhouse::scenarios {

/// The world files that the program carries, by their path in the source tree ("worlds/pioneer.inc"). Defined
/// by the build (embed.cmake).
std::map<std::string, std::string> embedded_files();

}  // namespace playhouse::scenarios
