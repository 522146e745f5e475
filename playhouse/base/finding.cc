#include "playhouse/base/finding.h"

namespace playhouse {

namespace {

constexpr std::string_view kWarning = "warning: ";

}  // namespace

Error as_warning(Error finding) {
  finding.text.insert(0, kWarning);
  return finding;
}

bool is_warning(const Error& finding) {
  return finding.text.starts_with(kWarning);
}

std::string finding(std::string_view kind, const Error& error) {
  if (is_warning(error)) return error.line();
  return Error{error.where, std::string(kind) + ": " + error.text}.line();
}

Error placed(std::string_view line) {
  for (std::size_t colon = line.find(':'); colon != std::string_view::npos;
       colon = line.find(':', colon + 1)) {
    const std::size_t end = line.find_first_not_of("0123456789", colon + 1);
    if (end == std::string_view::npos || end == colon + 1 || line.substr(end, 2) != ": ") continue;
    return {std::string(line.substr(0, end)), std::string(line.substr(end + 2))};
  }
  return {{}, std::string(line)};
}

}  // namespace playhouse
