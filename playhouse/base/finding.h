#pragma once

#include <string>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse {

/// Marks a finding among errors as a warning, such as a typo that may be the cause of the others.
Error as_warning(Error finding);
bool is_warning(const Error& finding);

/// Diagnostic line in the format of compilers, "file:line: error: what"; "error: what" without
/// a position. `kind` is "error" or "warning"; results of as_warning() are always warnings.
std::string finding(std::string_view kind, const Error& error);

/// Splits a warning, "file:line: what", into position and text; without a position everything is text.
Error placed(std::string_view line);

}  // namespace playhouse
