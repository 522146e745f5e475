#include "playhouse/controllers/library.h"

#include <dlfcn.h>

#include <exception>
#include <utility>

#include "playhouse/base/in_quotes.h"

namespace playhouse::controllers {
namespace {

/// dlerror() starts with the file's name; ours does so already.
std::string loader_says(const std::string& file) {
  const char* text = dlerror();
  std::string line = text ? text : "unknown error";
  if (line.starts_with(file + ": ")) line.erase(0, file.size() + 2);
  return line;
}

std::string why_not_ours(void* handle) {
  if (dlsym(handle, "Init")) {
    return "is a controller built for Stage's library; write PLAYHOUSE_CONTROLLER in its source and build it "
           "again";
  }
  return "is no controller: it lacks PLAYHOUSE_CONTROLLER";
}

}  // namespace

Result<Library> Library::open(const std::filesystem::path& path) {
  // A bare name would be looked for by the loader in its own places.
  const std::string file = std::filesystem::absolute(path).string();
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) return Error{escaped(file), "can't be loaded: " + escaped(loader_says(file))};
  Library library(handle, nullptr, file);

  using Version = std::uint32_t (*)();
  const auto version = reinterpret_cast<Version>(dlsym(handle, "playhouse_controller_version"));
  library.make_ = reinterpret_cast<Make>(dlsym(handle, "playhouse_controller_make"));
  if (!version || !library.make_) return Error{escaped(file), why_not_ours(handle)};
  library.version_ = version();
  if (library.version_ < kControllerVersionLeast || library.version_ > kControllerVersion) {
    return Error{escaped(file), "is built for controller version " + std::to_string(library.version_) +
                                    ", this program takes " + std::to_string(kControllerVersionLeast) +
                                    " to " + std::to_string(kControllerVersion) + "; build it again"};
  }
  return library;
}

Library::Library(Library&& other) noexcept
    : handle_(std::exchange(other.handle_, nullptr)),
      make_(other.make_),
      file_(std::move(other.file_)),
      version_(other.version_) {}

Library& Library::operator=(Library&& other) noexcept {
  std::swap(handle_, other.handle_);
  std::swap(make_, other.make_);
  std::swap(file_, other.file_);
  std::swap(version_, other.version_);
  return *this;
}

Library::~Library() {
  if (handle_) dlclose(handle_);
}

Result<std::unique_ptr<Controller>> Library::make() const {
  try {
    std::unique_ptr<Controller> controller(make_());
    if (!controller) return Error{escaped(file_), "made no controller"};
    return controller;
  } catch (const std::exception& error) {
    return Error{escaped(file_), escaped(error.what())};
  } catch (...) {
    return Error{escaped(file_), "threw something that is no std::exception"};
  }
}

std::string library_file(std::string_view name) {
  return std::string(name) + (name.ends_with(".so") ? "" : ".so");
}

std::filesystem::path find_library(std::string_view name, std::span<const std::filesystem::path> folders) {
  for (const std::filesystem::path& folder : folders) {
    std::filesystem::path file = folder / library_file(name);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored)) return file;
  }
  return {};
}

}  // namespace playhouse::controllers
