#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

#include "playhouse/app/commands/commands.h"
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
/// yet. Prints warnings and errors, and adds them to the report.
void try_out(const std::string& path, scene::CheckReport& report) {
  Service service({.port = 0, .web = std::nullopt}, {}, QuitTime::kIgnored);
  service.load_no_code();
  service.on_warning([&report](const std::string& warning) {
    report.has_warnings = true;
    const std::string line = finding("warning", placed(warning));
    if (std::ranges::find(report.lines, line) == report.lines.end()) print(line);
  });
  const bool is_cfg = path.ends_with(".cfg");
  Result<void> tried = is_cfg ? service.read_cfg(path) : service.read_world(path);
  if (tried) tried = service.make_devices();
  report.ok = tried.ok();
  if (tried) return;
  print(finding("error", tried.error()));
  for (const Error& other : service.other_errors()) print(finding("error", other));
}

scene::CheckReport check_one(const std::string& path) {
  scene::CheckReport report = scene::check_file(path);
  for (const std::string& line : report.lines) print(line);
  if (!report.ok || path.ends_with(".inc")) return report;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {  // a pipe can be read only once
    print(
        finding("warning", {path, "not a regular file, so engine, controllers and drivers were not tried"}));
    report.has_warnings = true;
    return report;
  }
  try_out(path, report);
  return report;
}

}  // namespace

int check(const CheckOptions& options) {
  log::open(0);
  bool good = true;
  for (const std::string& file : options.files) {
    const scene::CheckReport report = check_one(file);
    good = good && report.ok && !(options.strict && report.has_warnings);
  }
  return good ? kDone : kUsage;
}

}  // namespace playhouse::app
