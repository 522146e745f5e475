#include "playhouse/base/folders_of.h"

#include <cstdlib>

#include "playhouse/base/split.h"

namespace playhouse {

std::vector<std::string> folders_of(const char* variable) {
  const char* const value = std::getenv(variable);
  std::vector<std::string> folders;
  for (const std::string_view folder : split(value == nullptr ? "" : value, ':'))
    if (!folder.empty()) folders.emplace_back(folder);
  return folders;
}

}  // namespace playhouse
