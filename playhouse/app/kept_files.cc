#include "playhouse/app/kept_files.h"

#include <filesystem>
#include <system_error>

#include "playhouse/base/in_quotes.h"

namespace playhouse::app {

Result<void> keep_files(const std::string& output, std::span<const std::string> read) {
  std::error_code ignored;  // a missing file is no conflict
  for (const std::string& file : read)
    if (std::filesystem::equivalent(file, output, ignored))
      return Error{escaped(output), "is what is read: give another name"};
  return {};
}

std::vector<std::string> names_of(const config::SourceFiles& sources) {
  std::vector<std::string> names;
  for (const auto& [name, bytes] : sources.files) names.push_back(name);
  return names;
}

}  // namespace playhouse::app
