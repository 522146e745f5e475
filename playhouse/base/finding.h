#pragma once

#include <string>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse {

/// A finding among errors that is none by itself, as a word that may be the reason of the others.
Error as_warning(Error finding);
bool is_warning(const Error& finding);

/// A line about a file as editors follow it, "file:line: error: what"; "error: what" where there is no place.
/// `kind` is "error" or "warning"; what as_warning() made is a warning always.
std::string finding(std::string_view kind, const Error& error);

/// The parts of a warning, "file:line: what"; without a place, all of it is text.
Error placed(std::string_view line);

}  // namespace playhouse
