#include "playhouse/config/shipped_worlds.h"

#include <system_error>

#include "playhouse/base/in_quotes.h"
#include "playhouse/config/text/source_text.h"

namespace playhouse::config {
namespace {

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

bool has_worlds(const std::filesystem::path& folder) {
  return is_file(folder / "pioneer.inc");
}

}  // namespace

std::string shipped_worlds(const std::filesystem::path& program) {
  if (program.empty()) return {};
  const std::filesystem::path installed = (program / PLAYHOUSE_INSTALLED_WORLDS).lexically_normal();
  if (has_worlds(installed)) return installed.string() + "/";
  for (std::filesystem::path above = program; above.has_relative_path(); above = above.parent_path())
    if (has_worlds(above / "worlds")) return (above / "worlds").string() + "/";
  return {};
}

std::string did_you_mean_shipped(const std::string& path) {
  const std::string folder = shipped_worlds();
  const std::string shipped = folder + path.substr(folder_of(path).size());
  return folder.empty() || !is_file(shipped) ? "" : " (did you mean " + in_quotes(shipped) + "?)";
}

}  // namespace playhouse::config
