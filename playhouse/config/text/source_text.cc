#include "playhouse/config/text/source_text.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "playhouse/base/folders_of.h"
#include "playhouse/base/limits.h"
#include "playhouse/config/shipped_worlds.h"

namespace playhouse::config {
namespace {

Error too_large(std::size_t most) {
  return {{}, "cannot be read: larger than " + std::to_string(most >> 20) + " MiB"};
}

/// Reads to the end: pipes and files of the kernel do not announce their size.
Result<std::string> read_all(std::FILE& file, std::size_t most) {
  std::string text;
  char chunk[1 << 16];
  while (const std::size_t count = std::fread(chunk, 1, sizeof chunk, &file)) {
    text.append(chunk, count);
    if (text.size() > most) return too_large(most);
  }
  if (std::ferror(&file)) return Error{{}, std::string("cannot be read: ") + std::strerror(errno)};
  return text;
}

}  // namespace

Result<std::string> DiskFiles::read(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return Error{{}, "cannot be opened: no such file"};
  const bool pipes = by_ == NamedBy::kPerson;
  if (!std::filesystem::is_regular_file(status) && !(pipes && std::filesystem::is_fifo(status))) {
    return Error{{},
                 std::string("cannot be opened: ") +
                     (pipes ? "neither a regular file nor a pipe" : "not a regular file")};
  }
  // Some regular files of the kernel block their readers.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | (pipes ? 0 : O_NONBLOCK));
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb"), &std::fclose);
  if (!file) return Error{{}, std::string("cannot be opened: ") + std::strerror(errno)};
  struct stat opened {};  // re-checked: the name may refer to another file now
  if (!pipes && (::fstat(descriptor, &opened) != 0 || !S_ISREG(opened.st_mode)))
    return Error{{}, "cannot be opened: not a regular file"};
  return read_all(*file, most_);
}

std::vector<std::string> DiskFiles::search_path() const {
  std::vector<std::string> folders;
  for (const char* variable : {"PLAYHOUSE_PATH", "STAGEPATH"})
    for (const std::string& folder : folders_of(variable)) folders.push_back(folder + "/");
  if (std::string shipped = shipped_worlds(); !shipped.empty()) folders.push_back(std::move(shipped));
  return folders;
}

std::vector<std::string> DiskFiles::names_in(const std::string& folder) const {
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error), end;
       !error && entry != end; entry.increment(error))
    names.push_back(entry->path().filename().string());
  std::ranges::sort(names);
  return names;
}

Result<std::string> RecordedFiles::read(const std::string& path) {
  Result<std::string> text = files_.read(path);
  if (text) kept_.files[path] = *text;
  return text;
}

Result<std::string> MemoryFiles::read(const std::string& path) {
  const auto found = files_.find(path);
  if (found == files_.end()) return Error{{}, "cannot be opened: no such file"};
  if (found->second.size() > limits::kFileBytes) return too_large(limits::kFileBytes);
  return found->second;
}

std::vector<std::string> MemoryFiles::names_in(const std::string& folder) const {
  std::vector<std::string> names;
  for (const auto& [path, text] : files_)
    if (folder_of(path) == folder) names.push_back(path.substr(folder.size()));
  return names;
}

Result<void> SourceTexts::count(std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ <= limits::kFileBytes) return {};
  return Error{{},
               "more than " + std::to_string(limits::kFileBytes >> 20) + " MiB of text with all includes"};
}

Result<std::uint32_t> SourceTexts::add(const std::string& path, std::string text) {
  if (const Result<void> counted = count(text.size()); !counted) return counted.error();
  const auto row = static_cast<std::uint32_t>(texts_.size());
  rows_.emplace(path, row);
  names_.push_back(path);
  texts_.push_back(std::move(text));
  return row;
}

std::optional<std::uint32_t> SourceTexts::find(const std::string& path) const {
  const auto found = rows_.find(path);
  return found == rows_.end() ? std::nullopt : std::optional(found->second);
}

Result<void> SourceTexts::use_again(std::uint32_t row) {
  return count(texts_[row].size());
}

std::string folder_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string{} : std::string(path.substr(0, slash + 1));
}

std::string containing_folder(std::string_view path) {
  std::string folder = folder_of(path);
  if (folder.empty()) return ".";
  if (folder.size() > 1) folder.pop_back();
  return folder;
}

std::string resolve(const std::string& folder, std::string_view name) {
  if (!name.empty() && (name.front() == '/' || name.front() == '~')) return std::string(name);
  return folder + std::string(name);
}

}  // namespace playhouse::config
