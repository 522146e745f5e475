#pragma once

/// Sanitising of texts that models say, for all
/// sources: world files, controllers, Player clients.

#include <string>
#include <string_view>

namespace playhouse::world {

/// One line of UTF-8, at most limits::kSayBytes: truncated at the first NUL and to
/// whole characters; control characters become spaces, invalid bytes question marks.
std::string spoken(std::string_view text);

/// True if spoken() leaves the text unchanged.
bool can_be_said(std::string_view text);

}  // namespace playhouse::world
