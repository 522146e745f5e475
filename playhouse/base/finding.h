#pragma once

#include <string>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse {

/// A line about a file as editors follow it, "file:line: error: what"; "error: what" where there is no place.
/// `kind` is "error" or "warning".
std::string finding(std::string_view kind, const Error& error);

/// The parts of a warning, "file:line: what"; without a place, all of it is text.
Error placed(std::string_view line);

}  // namespace playhouse
