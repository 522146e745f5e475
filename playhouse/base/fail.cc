#include "playhouse/base/fail.h"

#include "playhouse/base/finding.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"

namespace playhouse {

int fail(const Error& error, Exit code) {
  log::error("{}", error.line());
  return code;
}

int fail_at(const Error& error, Exit code) {
  log::tell(log::Level::kError, error);
  return code;
}

int fail_in_file(const Error& error, const std::vector<Error>& others) {
  log::tell(log::Level::kError, error);
  for (const Error& other : others) {
    if (is_warning(other)) {
      warn(other.where + ": " + other.text.substr(other.text.find(' ') + 1));
    } else {
      log::tell(log::Level::kError, other);
    }
  }
  return kUsage;
}

void warn(const std::string& line) {
  log::tell(log::Level::kWarn, placed(line));
}

}  // namespace playhouse
