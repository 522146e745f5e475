#include "playhouse/base/folders_of.h"

#include <cstdlib>
#include <sstream>

namespace playhouse {

std::vector<std::string> folders_of(const char* variable) {
  const char* const value = std::getenv(variable);
  std::istringstream rest{value == nullptr ? "" : value};
  std::vector<std::string> folders;
  for (std::string folder; std::getline(rest, folder, ':');)
    if (!folder.empty()) folders.push_back(folder);
  return folders;
}

}  // namespace playhouse
