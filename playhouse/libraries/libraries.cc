#include "playhouse/libraries/libraries.h"

#include <algorithm>
#include <sstream>
#include <system_error>

#include "playhouse/base/folders_of.h"
#include "playhouse/base/log.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::libraries {
namespace {

/// Like Stage, accepts names with the extension.
std::string file_of(std::string_view name) {
  return std::string(name) + (name.ends_with(".so") ? "" : ".so");
}

/// The first match in the search path, then among the allowed files; empty if there is none.
std::filesystem::path find(std::string_view name, const Libraries& libraries) {
  for (const std::filesystem::path& folder : libraries.folders) {
    std::filesystem::path file = folder / file_of(name);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored)) return file;
  }
  const auto allowed = std::ranges::find_if(
      libraries.allowed, [&](const std::filesystem::path& file) { return file.filename() == file_of(name); });
  return allowed == libraries.allowed.end() ? std::filesystem::path() : *allowed;
}

/// All names in the search path, for suggestions.
std::vector<std::string> known_names(const WantedLibrary& wanted, const Libraries& libraries) {
  std::vector<std::string> words(wanted.built_ins.begin(), wanted.built_ins.end());
  for (const std::filesystem::path& folder : libraries.folders) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".so" && entry.is_regular_file(ignored))
        words.push_back(entry.path().stem().string());
    }
  }
  // Directory order is unspecified.
  std::sort(words.begin() + static_cast<std::ptrdiff_t>(wanted.built_ins.size()), words.end());
  return words;
}

Error unknown(const WantedLibrary& wanted, const Libraries& libraries) {
  const std::string no = "no " + std::string(wanted.provided.what) + " " + in_quotes(wanted.name);
  const std::string file = in_quotes(file_of(wanted.name));
  if (std::filesystem::path(wanted.name).is_absolute())
    return {wanted.where, no + ": there is no file " + file};
  const std::vector<std::string> words = known_names(wanted, libraries);
  const std::vector<std::string_view> candidates(words.begin(), words.end());
  if (const std::string nearest = did_you_mean(wanted.name, candidates); !nearest.empty())
    return {wanted.where, no + nearest};
  std::string places;
  for (const std::filesystem::path& folder : libraries.folders)
    places += (places.empty() ? "" : ", ") + escaped(folder.string());
  const char* const not_built_in = wanted.built_ins.empty() ? ": " : ": it is not built in, and ";
  return {wanted.where, no + not_built_in + file + " is not in " + places +
                            "; if you trust one elsewhere, run with --allow-library FILE.so"};
}

/// True if a name escapes the search path.
bool leads_outside(std::string_view name) {
  const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
  return path.is_absolute() || (!path.empty() && *path.begin() == "..");
}

std::string shown(const WantedLibrary& wanted) {
  return std::string(wanted.provided.what) + " " + in_quotes(wanted.name);
}

/// True if a file is in one of the folders, or below it, whichever way its name takes.
bool is_within(const std::filesystem::path& file, const Libraries& libraries) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(file, error);
  if (error) return false;
  return std::ranges::any_of(libraries.folders, [&](const std::filesystem::path& folder) {
    std::error_code none;
    const std::filesystem::path within = std::filesystem::canonical(folder, none);
    return !none && std::ranges::mismatch(within, real).in1 == within.end();
  });
}

bool is_allowed(const std::string& name, const std::filesystem::path& file, const Libraries& libraries) {
  std::error_code ignored;
  return !leads_outside(name) || is_within(file, libraries) ||
         std::ranges::any_of(libraries.allowed, [&](const std::filesystem::path& allowed) {
           return std::filesystem::equivalent(file, allowed, ignored);
         });
}

}  // namespace

std::vector<std::filesystem::path> library_folders(const std::string& of_file, const char* of_original,
                                                   const std::filesystem::path& program_folder) {
  std::vector<std::filesystem::path> folders;
  if (!of_file.empty()) folders.emplace_back(of_file);
  for (const char* variable : {"PLAYHOUSE_PATH", of_original})
    for (std::string& named : folders_of(variable)) folders.emplace_back(std::move(named));
  folders.push_back(program_folder);
  return folders;
}

bool is_there(const WantedLibrary& wanted, const Libraries& libraries) {
  return !find(wanted.name, libraries).empty();
}

Result<std::filesystem::path> locate(const WantedLibrary& wanted, const Libraries& libraries,
                                     std::vector<std::string>& warnings) {
  const std::filesystem::path file = find(wanted.name, libraries);
  if (file.empty()) return unknown(wanted, libraries);
  const std::string which = shown(wanted);
  const std::string path = escaped(std::filesystem::absolute(file).lexically_normal().string());
  const bool allowed = is_allowed(wanted.name, file, libraries);
  if (libraries.use == Libraries::LibraryUse::kFind) {
    warnings.push_back(wanted.where + ": " + which + " is " + path +
                       ", which is there and not checked: checking loads no code" +
                       (allowed ? "" : "; running it takes --allow-library " + path));
    return std::filesystem::path();
  }
  if (!allowed) {
    return Error{wanted.where, which + " is code outside the folders of " +
                                   std::string(wanted.provided.what) +
                                   "s; if you trust it, run with --allow-library " + path};
  }
  log::info("{}: loads {}", which, path);
  return file;
}

Result<std::shared_ptr<SharedLibrary>> load(const WantedLibrary& wanted, const Libraries& libraries,
                                            std::vector<std::string>& warnings) {
  const Result<std::filesystem::path> file = locate(wanted, libraries, warnings);
  if (!file) return file.error();
  if (file->empty()) return std::shared_ptr<SharedLibrary>();
  Result<SharedLibrary> library = SharedLibrary::open(*file, wanted.provided);
  if (!library) return Error{wanted.where, shown(wanted) + ": " + library.error().line()};
  return std::make_shared<SharedLibrary>(std::move(*library));
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(std::move(word));
  return words;
}

}  // namespace playhouse::libraries
