#include "playhouse/app/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "playhouse/base/in_quotes.h"

namespace playhouse::app {
namespace {

namespace fs = std::filesystem;

Error fault(const std::string& path, const std::string& what, int code) {
  return {escaped(path), what + ": " + std::generic_category().message(code)};
}

}  // namespace

Result<std::string> read_file(const std::string& path, config::NamedBy by, std::size_t most) {
  Result<std::string> text = config::DiskFiles(by, most).read(path);
  if (!text) return Error{escaped(path), text.error().text};
  return text;
}

Result<void> check_writable(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return fault(path, "cannot be written", EISDIR);
  if (fs::exists(path, ignored)) return {};
  const fs::path folder = fs::path(path).parent_path() / "";  // with its slash: no file has this name
  if (access(folder.empty() ? "." : folder.c_str(), W_OK) != 0)
    return fault(path, "cannot be written", errno);
  return {};
}

Result<void> write_file(const std::string& path, std::span<const std::byte> bytes) {
  const std::string unfinished = path + ".part";
  std::FILE* const file = std::fopen(unfinished.c_str(), "wb");
  if (!file) return fault(path, "cannot be written", errno);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int write_error = errno;
  const bool closed = std::fclose(file) == 0;
  if (written && closed && std::rename(unfinished.c_str(), path.c_str()) == 0) return {};
  const int code = written ? errno : write_error;
  std::remove(unfinished.c_str());
  return fault(path, "cannot be written", code);
}

}  // namespace playhouse::app
