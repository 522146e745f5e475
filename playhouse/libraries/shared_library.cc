#include "playhouse/libraries/shared_library.h"

#include <dlfcn.h>
#include <elf.h>

#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

namespace playhouse::libraries {
namespace {

/// dlerror() starts with the file name, which our message has already.
std::string loader_says(const std::string& file) {
  const char* text = dlerror();
  std::string line = text ? text : "unknown error";
  if (line.starts_with(file + ": ")) line.erase(0, file.size() + 2);
  return line;
}

std::string why_not(const SharedLibrary& library, const LibraryAbi& provided) {
  const std::string macro(provided.macro);
  if (library.symbol("Init"))
    return "is a controller built for Stage's library; write " + macro + " in its source and build it again";
  return "is not a " + std::string(provided.what) + ": it lacks " + macro;
}

/// Reads a part of a file. False if it is not there.
template <typename Part>
bool read_at(std::ifstream& file, std::uint64_t offset, Part& part) {
  file.seekg(static_cast<std::streamoff>(offset));
  return static_cast<bool>(file.read(reinterpret_cast<char*>(&part), sizeof part));
}

/// True if an ELF file ends before what its headers say that it has: the loader maps that all the same, and
/// the first look at it ends the program by SIGBUS. The loader checks everything else. Source: elf(5).
bool is_cut_off(const std::string& path) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  Elf64_Ehdr head;
  if (error || !read_at(file, 0, head) || std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 ||
      head.e_ident[EI_CLASS] != ELFCLASS64)
    return false;
  const auto ends_within = [size](std::uint64_t offset, std::uint64_t bytes) {
    return offset <= size && bytes <= size - offset;
  };
  if (!ends_within(head.e_shoff, std::uint64_t{head.e_shnum} * head.e_shentsize)) return true;
  for (std::uint64_t i = 0; i < head.e_phnum; ++i) {
    Elf64_Phdr segment;
    if (!read_at(file, head.e_phoff + i * sizeof segment, segment)) return true;
    if (segment.p_type == PT_LOAD && !ends_within(segment.p_offset, segment.p_filesz)) return true;
  }
  return false;
}

}  // namespace

Result<SharedLibrary> SharedLibrary::open(const std::filesystem::path& path, const LibraryAbi& provided) {
  // An absolute path, since dlopen() would search its own path for a bare name.
  const std::string file = std::filesystem::absolute(path).string();
  if (is_cut_off(file))
    return Error{escaped(file), "can't be loaded: its end is missing; build or copy it again"};
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) return Error{escaped(file), "can't be loaded: " + escaped(loader_says(file))};
  SharedLibrary library(handle, file);

  using Version = std::uint32_t (*)();
  const std::string prefix(provided.prefix);
  const auto version = reinterpret_cast<Version>(library.symbol(prefix + "_version"));
  library.make_ = library.symbol(prefix + "_make");
  if (!version || !library.make_) return Error{escaped(file), why_not(library, provided)};
  library.version_ = version();
  if (library.version_ < provided.version_least || library.version_ > provided.version) {
    return Error{escaped(file), "is built for " + std::string(provided.what) + " version " +
                                    std::to_string(library.version_) + ", this program takes " +
                                    std::to_string(provided.version_least) + " to " +
                                    std::to_string(provided.version) + "; build it again"};
  }
  return library;
}

SharedLibrary::SharedLibrary(SharedLibrary&& other) noexcept
    : handle_(std::exchange(other.handle_, nullptr)),
      make_(other.make_),
      file_(std::move(other.file_)),
      version_(other.version_) {}

SharedLibrary& SharedLibrary::operator=(SharedLibrary&& other) noexcept {
  std::swap(handle_, other.handle_);
  std::swap(make_, other.make_);
  std::swap(file_, other.file_);
  std::swap(version_, other.version_);
  return *this;
}

SharedLibrary::~SharedLibrary() {
  if (handle_) dlclose(handle_);
}

void* SharedLibrary::symbol(const std::string& name) const {
  return dlsym(handle_, name.c_str());
}

}  // namespace playhouse::libraries
