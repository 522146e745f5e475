#pragma once

/// Report of `playhouse check FILE`.

#include <string>
#include <vector>

namespace playhouse::scene {

struct CheckReport {
  bool ok = false;  // no errors
  bool has_warnings = false;
  std::vector<std::string> lines = {};  // warnings, then errors, or meshes with sizes and a summary
};

/// Checks a world (.world), an include file for worlds (.inc: syntax only)
/// or a configuration (.cfg: including the worlds that its drivers load).
CheckReport check_file(const std::string& path);

}  // namespace playhouse::scene
