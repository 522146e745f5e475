#pragma once

/// SharedLibrary: a shared library with code for worlds, opened and checked. It stays open as long as the
/// object lives, which must be longer than anything it made.

#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/result.h"

namespace playhouse::libraries {

/// What a library provides, and how it says so: the functions PREFIX_version() and PREFIX_make(), which a
/// macro of the header that it is built with defines.
struct Provided {
  std::string_view what;                 // "controller"
  std::string_view macro;                // "PLAYHOUSE_CONTROLLER"
  std::string_view prefix;               // "playhouse_controller"
  std::uint32_t version_least, version;  // of that header, for which a library may be built
};

class SharedLibrary {
 public:
  /// Opens `file` and checks its version. Fails with one line that names the file and says what to do.
  static Result<SharedLibrary> open(const std::filesystem::path& file, const Provided& provided);

  SharedLibrary(SharedLibrary&&) noexcept;
  SharedLibrary& operator=(SharedLibrary&&) noexcept;
  ~SharedLibrary();

  /// Of the header for which it is built.
  std::uint32_t version() const { return version_; }
  const std::string& file() const { return file_; }

  /// The function or variable of this name, or nullptr.
  void* symbol(const std::string& name) const;

  /// A new object of the class that it provides. Fails if its constructor throws or gives nothing.
  template <typename Made>
  Result<std::unique_ptr<Made>> make() const {
    try {
      std::unique_ptr<Made> made(reinterpret_cast<Made* (*)()>(make_)());
      if (!made) return Error{escaped(file_), "made nothing"};
      return made;
    } catch (const std::exception& error) {
      return Error{escaped(file_), escaped(error.what())};
    } catch (...) {
      return Error{escaped(file_), "threw something that is no std::exception"};
    }
  }

 private:
  SharedLibrary(void* handle, std::string file) : handle_(handle), file_(std::move(file)) {}

  void* handle_;
  void* make_ = nullptr;
  std::string file_;
  std::uint32_t version_ = 0;
};

}  // namespace playhouse::libraries
