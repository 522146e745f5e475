#include "playhouse/config/text/file_search.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::config {

std::filesystem::path physical_path(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::path whole = std::filesystem::absolute(file, ignored);
  return std::filesystem::weakly_canonical(whole.parent_path(), ignored) / whole.filename();
}

std::filesystem::path path_from(const std::filesystem::path& beside, const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path folder = fs::absolute(beside, ignored).lexically_normal().parent_path();
  const fs::path named = fs::absolute(file, ignored).lexically_normal().lexically_relative(folder);
  if (fs::equivalent(fs::absolute(beside, ignored).parent_path() / named, file, ignored)) return named;
  return physical_path(file).lexically_relative(physical_path(beside).parent_path());
}

std::vector<std::string> folders_for(const std::string& top_level, const std::string& named_by,
                                     const FileReader& files) {
  std::vector<std::string> folders{folder_of(top_level)};
  const auto add = [&](std::string folder) {
    if (std::ranges::find(folders, folder) == folders.end()) folders.push_back(std::move(folder));
  };
  add(folder_of(named_by));
  for (std::string& folder : files.search_path()) add(std::move(folder));
  return folders;
}

namespace {

/// The first of the folders that has a file of this name; empty if there is none.
std::string folder_with(const std::vector<std::string>& folders, std::string_view name,
                        const FileReader& files) {
  for (const std::string& folder : folders)
    if (std::ranges::count(files.names_in(folder), name) > 0) return folder.empty() ? "./" : folder;
  return {};
}

}  // namespace

std::string also_not_in(const std::vector<std::string>& folders, std::string_view name,
                        const FileReader& files, const std::function<bool(std::string_view)>& fits) {
  const bool is_whole = resolve("", name) == resolve("/", name);  // absolute
  const std::string below = is_whole ? "" : folder_of(name);
  if (const std::string_view alone = name.substr(folder_of(name).size()); is_whole)  // of another machine
    if (const std::string folder = folder_with(folders, alone, files); !folder.empty())
      return "; " + in_quotes(alone) + " alone is found in " + escaped(folder);
  std::vector<std::string> names;
  std::string places;
  for (const std::string& folder : folders) {
    for (const std::string& found : files.names_in(resolve(folder, below)))
      if (fits(found)) names.push_back(below + found);
    if (folder != folders.front()) places += (places.empty() ? "" : ", ") + escaped(folder);
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  return (is_whole || places.empty() ? "" : ", also not in " + places) + did_you_mean(name, candidates);
}

Result<FoundFile> find_file(const std::vector<std::string>& folders, std::string_view name, FileReader& files,
                            const std::function<bool(const std::string&)>& is_known,
                            const std::function<bool(std::string_view)>& fits) {
  std::string why;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    std::string path = resolve(folders[i], name);
    if (is_known(path)) return FoundFile{std::move(path), std::nullopt, i};
    Result<std::string> bytes = files.read(path);
    if (bytes) return FoundFile{std::move(path), std::move(*bytes), i};
    if (why.empty()) why = bytes.error().text;
  }
  return Error{resolve(folders.front(), name), why + also_not_in(folders, name, files, fits)};
}

}  // namespace playhouse::config
