#pragma once

/// SharedLibrary: a loaded and validated shared library. It stays loaded
/// during the object's lifetime, which must exceed that of everything it made.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/result.h"
#include "playhouse/libraries/thrown_by.h"

namespace playhouse::libraries {

/// ABI of a kind of library: it exports PREFIX_version() and
/// PREFIX_make(), defined by a macro of the header it is built with.
struct LibraryAbi {
  std::string_view what;                 // "controller"
  std::string_view macro;                // "PLAYHOUSE_CONTROLLER"
  std::string_view prefix;               // "playhouse_controller"
  std::uint32_t version_least, version;  // supported versions of that header
};

class SharedLibrary {
 public:
  /// Loads `file` and checks its version. Fails with a one-line message with the file name and a remedy.
  static Result<SharedLibrary> open(const std::filesystem::path& file, const LibraryAbi& provided);

  SharedLibrary(SharedLibrary&&) noexcept;
  SharedLibrary& operator=(SharedLibrary&&) noexcept;
  ~SharedLibrary();

  /// Version of the header it was built with.
  std::uint32_t version() const { return version_; }
  const std::string& file() const { return file_; }

  /// Address of an exported symbol, or nullptr.
  void* symbol(const std::string& name) const;

  /// Makes an object of its class. Fails if the constructor throws or returns null.
  template <typename Made>
  Result<std::unique_ptr<Made>> make() const {
    std::unique_ptr<Made> made;
    std::string thrown;
    const auto construct = [&] { made.reset(reinterpret_cast<Made* (*)()>(make_)()); };
    if (const char* why = thrown_by(thrown, construct)) return Error{escaped(file_), why};
    if (!made) return Error{escaped(file_), "made nothing"};
    return made;
  }

 private:
  SharedLibrary(void* handle, std::string file) : handle_(handle), file_(std::move(file)) {}

  void* handle_;
  void* make_ = nullptr;
  std::string file_;
  std::uint32_t version_ = 0;
};

}  // namespace playhouse::libraries
