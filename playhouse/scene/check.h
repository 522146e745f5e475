#pragma once

/// What `playhouse check FILE` says about a file.

#include <string>
#include <vector>

namespace playhouse::scene {

struct CheckReport {
  bool ok = false;
  std::vector<std::string> lines;  // warnings, then the error if any, then a summary of what the file holds
};

/// Checks a world (.world), an include file for worlds (.inc: its syntax) or a configuration (.cfg: with the
/// worlds that its drivers load).
CheckReport check_file(const std::string& path);

}  // namespace playhouse::scene
