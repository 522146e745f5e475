#pragma once

/// Sources of a scene or configuration: where bytes come from (disk, or memory
/// in tests and fuzzers), and positions in them. Independent of grammar.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/config/text/source_line.h"

namespace playhouse::config {

/// Reads files by name; at most limits::kFileBytes.
class FileReader {
 public:
  virtual ~FileReader() = default;
  /// Fails with a message that starts with "cannot", without the file name (the caller knows it).
  virtual Result<std::string> read(const std::string& path) = 0;
  /// Folders, with trailing slash, to search for includes
  /// and bitmaps that are not beside the referring file.
  virtual std::vector<std::string> search_path() const { return {}; }
  /// Sorted names of the files in a folder, for suggestions.
  /// The folder has a trailing slash, or is "".
  virtual std::vector<std::string> names_in(const std::string& folder) const = 0;
};

/// Origin of a file name: a user, who may pass a pipe (`playhouse check <(...)`), or another
/// file. For the latter only regular files are read: a pipe without a writer would block forever.
enum class NamedBy : std::uint8_t { kPerson, kFile };

/// Files on disk.
class DiskFiles final : public FileReader {
 public:
  /// `most`: bytes of a file.
  explicit DiskFiles(NamedBy by = NamedBy::kFile, std::size_t most = limits::kFileBytes)
      : by_(by), most_(most) {}
  Result<std::string> read(const std::string& path) override;
  /// The folders of PLAYHOUSE_PATH and of STAGEPATH, then
  /// the worlds that come with the program (shipped_worlds.h).
  std::vector<std::string> search_path() const override;
  std::vector<std::string> names_in(const std::string& folder) const override;

 private:
  NamedBy by_;
  std::size_t most_;
};

/// Files in memory.
class MemoryFiles final : public FileReader {
 public:
  explicit MemoryFiles(std::map<std::string, std::string> files, std::vector<std::string> search_path = {})
      : files_(std::move(files)), search_path_(std::move(search_path)) {}
  Result<std::string> read(const std::string& path) override;
  std::vector<std::string> search_path() const override { return search_path_; }
  std::vector<std::string> names_in(const std::string& folder) const override;

 private:
  std::map<std::string, std::string> files_;
  std::vector<std::string> search_path_;
};

/// All files that a world was loaded from, by path,
/// so that it can be loaded again without the disk.
struct SourceFiles {
  std::string path;  // of the top-level one
  std::map<std::string, std::string> files;
  std::vector<std::string> search_path;
};

/// Delegates to another reader, and keeps everything read in `kept`.
class RecordedFiles final : public FileReader {
 public:
  RecordedFiles(FileReader& files, SourceFiles& kept) : files_(files), kept_(kept) {}
  Result<std::string> read(const std::string& path) override;
  std::vector<std::string> search_path() const override { return files_.search_path(); }
  std::vector<std::string> names_in(const std::string& folder) const override {
    return files_.names_in(folder);
  }

 private:
  FileReader& files_;
  SourceFiles& kept_;
};

/// Owns all texts of a world or configuration file; views into them are valid during its lifetime.
class SourceTexts {
 public:
  /// Stores `text` under `path` and returns its row, also that of its name. Fails,
  /// without a file name, if all uses of texts together exceed limits::kFileBytes.
  Result<std::uint32_t> add(const std::string& path, std::string text);
  /// The row of a file stored already.
  std::optional<std::uint32_t> find(const std::string& path) const;
  /// Counts another use of a text against the limit, like add().
  Result<void> use_again(std::uint32_t row);

  std::string_view text(std::uint32_t row) const { return texts_[row]; }
  const std::vector<std::string>& file_names() const { return names_; }
  std::string at(SourceLine where) const {
    return escaped(names_[where.file]) + ":" + std::to_string(where.line);
  }

 private:
  Result<void> count(std::size_t bytes);

  std::deque<std::string> texts_;  // stable references, for views
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t, std::less<>> rows_;
  std::size_t bytes_ = 0;
};

/// Folder of a path with trailing slash, or "".
std::string folder_of(std::string_view path);

/// The same as a path of its own: without the slash, "." for "".
std::string containing_folder(std::string_view path);

/// `name` unchanged if it starts with '/' or '~', else `folder` + `name`.
std::string resolve(const std::string& folder, std::string_view name);

}  // namespace playhouse::config
