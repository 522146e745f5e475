#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

#include "playhouse/app/commands.h"
#include "playhouse/app/service.h"
#include "playhouse/base/finding.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/scene/check.h"

namespace playhouse::app {
namespace {

void print(const std::string& line) {
  fmt::print("{}\n", escaped(line));
}

/// Checks beyond the file itself: engines, controllers and drivers that reject it or skip
/// something. Controller libraries are located but not loaded, since the file is not trusted
/// yet. Prints warnings that are not in `report`, and errors. True if there were no errors.
bool try_out(const std::string& path, const scene::CheckReport& report) {
  Service service({.port = 0, .web = std::nullopt}, {}, QuitTime::kIgnored);
  service.load_no_code();
  service.on_warning([&report](const std::string& warning) {
    const std::string line = finding("warning", placed(warning));
    if (std::ranges::find(report.lines, line) == report.lines.end()) print(line);
  });
  const bool is_cfg = path.ends_with(".cfg");
  Result<void> tried = is_cfg ? service.read_cfg(path) : service.read_world(path);
  if (tried) tried = service.make_devices();
  if (tried) return true;
  print(finding("error", tried.error()));
  for (const Error& other : service.other_errors()) print(finding("error", other));
  return false;
}

/// True if the file is valid.
bool check_one(const std::string& path) {
  const scene::CheckReport report = scene::check_file(path);
  for (const std::string& line : report.lines) print(line);
  if (!report.ok || path.ends_with(".inc")) return report.ok;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {  // a pipe can be read only once
    print(
        finding("warning", {path, "not a regular file, so engine, controllers and drivers were not tried"}));
    return true;
  }
  return try_out(path, report);
}

}  // namespace

int check(const CheckOptions& options) {
  log::open(0);
  bool good = true;
  for (const std::string& file : options.files) good = check_one(file) && good;
  return good ? kDone : kUsage;
}

}  // namespace playhouse::app
