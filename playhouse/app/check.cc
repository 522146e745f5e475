#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

#include "playhouse/app/commands.h"
#include "playhouse/app/house.h"
#include "playhouse/base/log.h"
#include "playhouse/scene/check.h"

namespace playhouse::app {
namespace {

/// What the file itself can't show: engines, controllers and drivers that refuse it or leave something out.
/// Prints the warnings that `report` has not got.
Result<void> try_out(const std::string& path, const scene::CheckReport& report) {
  House house({.port = 0, .web = std::nullopt}, {}, QuitTime::kIgnored);
  house.on_warning([&report](const std::string& warning) {
    const bool known = std::ranges::any_of(
        report.lines, [&](const std::string& line) { return line.find(warning) != std::string::npos; });
    if (!known) fmt::print("warning: {}\n", warning);
  });
  const bool is_cfg = path.ends_with(".cfg");
  if (const Result<void> read = is_cfg ? house.read_cfg(path) : house.read_world(path); !read)
    return read.error();
  return house.furnish();
}

}  // namespace

int check(const CheckOptions& options) {
  const scene::CheckReport report = scene::check_file(options.file);
  for (const std::string& line : report.lines) fmt::print("{}\n", line);
  if (!report.ok) return kUsage;
  if (options.file.ends_with(".inc")) return kDone;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(options.file, ignored)) {  // a pipe gives what it has only once
    fmt::print("warning: {}: not a regular file, so engine, controllers and drivers were not tried\n",
               options.file);
    return kDone;
  }
  log::open(0);
  if (const Result<void> tried = try_out(options.file, report); !tried) {
    fmt::print("error: {}\n", tried.error().line());
    return kUsage;
  }
  return kDone;
}

}  // namespace playhouse::app
