#pragma once

/// Library: a controller's shared library, opened and checked. It stays open as long as the object lives,
/// which must be longer than any controller it made.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/controllers/controller.h"

namespace playhouse::controllers {

class Library {
 public:
  /// Opens `file` and checks its version. Fails with one line that names the file and says what to do.
  static Result<Library> open(const std::filesystem::path& file);

  Library(Library&&) noexcept;
  Library& operator=(Library&&) noexcept;
  ~Library();

  /// Of controller.h for which it is built.
  std::uint32_t version() const { return version_; }

  /// A new controller. Fails if its constructor throws or gives nothing.
  Result<std::unique_ptr<Controller>> make() const;

 private:
  using Make = Controller* (*)();
  Library(void* handle, Make make, std::string file) : handle_(handle), make_(make), file_(std::move(file)) {}

  void* handle_;
  Make make_;
  std::string file_;
  std::uint32_t version_ = 0;
};

/// The file of a controller's library: NAME.so. The name may have the ending already, as in Stage.
std::string library_file(std::string_view name);

/// The first library_file() in the folders; empty if there is none.
std::filesystem::path find_library(std::string_view name, std::span<const std::filesystem::path> folders);

}  // namespace playhouse::controllers
