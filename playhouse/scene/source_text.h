#pragma once

/// The bytes behind a scene or configuration: where they come from (disk, or memory in tests and fuzzers) and
/// which file and line a piece of text belongs to. Knows no grammar.

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// Gives the bytes of a file by name; at most limits::kFileBytes.
class FileReader {
 public:
  virtual ~FileReader() = default;
  /// Fails with a text that starts with "cannot" and names no file (the caller knows it).
  virtual Result<std::string> read(const std::string& path) = 0;
  /// Folders, each with its final slash, where an include or a bitmap is looked for that is not beside the
  /// files that name it.
  virtual std::vector<std::string> search_path() const { return {}; }
  /// Names of the files in a folder, in order, to tell what was meant. The folder has its final slash, or is
  /// "".
  virtual std::vector<std::string> names_in(const std::string& folder) const = 0;
};

/// Who named a file: a person, who may mean a pipe (`playhouse check <(...)`), or another file. There a pipe
/// that nobody writes would make everybody wait for ever, so regular files alone are read.
enum class NamedBy : std::uint8_t { kPerson, kFile };

/// Files of this machine.
class DiskFiles final : public FileReader {
 public:
  explicit DiskFiles(NamedBy by = NamedBy::kFile) : by_(by) {}
  Result<std::string> read(const std::string& path) override;
  /// The folders of PLAYHOUSE_PATH and of STAGEPATH, then the worlds that come with the program: `worlds` in
  /// a folder above the program's own.
  std::vector<std::string> search_path() const override;
  std::vector<std::string> names_in(const std::string& folder) const override;

 private:
  NamedBy by_;
};

/// Files that exist in memory only.
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

/// The files that a scene was made of, by the paths under which they were read, to make it again without
/// them.
struct SourceFiles {
  std::string path;  // of the top-level one
  std::map<std::string, std::string> files;
  std::vector<std::string> search_path;
};

/// Reads as another reader does, and keeps all that was read in `kept`.
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

/// Owns every text of one scene, so that views into them stay valid as long as it lives.
class SourceTexts {
 public:
  /// Keeps `text` under `path` and gives its row, which is also that of its name. Fails, with a text that
  /// names no file, when all uses of texts together exceed limits::kFileBytes.
  Result<std::uint32_t> add(const std::string& path, std::string text);
  /// The row of a file that is here already.
  std::optional<std::uint32_t> find(const std::string& path) const;
  /// Counts one more use of a text, as add() does.
  Result<void> use_again(std::uint32_t row);

  std::string_view text(std::uint32_t row) const { return texts_[row]; }
  const std::vector<std::string>& file_names() const { return names_; }
  std::string at(SourceLine where) const {
    return escaped(names_[where.file]) + ":" + std::to_string(where.line);
  }

 private:
  Result<void> count(std::size_t bytes);

  std::deque<std::string> texts_;  // a deque, so that views survive growth
  std::vector<std::string> names_;
  std::map<std::string, std::uint32_t, std::less<>> rows_;
  std::size_t bytes_ = 0;
};

/// Folder part of a path with its final slash, or "".
std::string folder_of(std::string_view path);

/// `name` as it is when it starts with '/' or '~', else `folder` + `name`.
std::string resolve(const std::string& folder, std::string_view name);

}  // namespace playhouse::scene
