#pragma once

/// Files of guests: a line for each, with role, token and name; a guest's link contains the token. docs/guests.md.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/server/guests/guest_book.h"

namespace playhouse::web_server {

/// Limit on the size of a guest file.  [B]
inline constexpr std::size_t kGuestFileBytes = 1 << 20;

/// Parses `role token [name]` lines; # begins a comment, and token
/// ? is replaced by a random one. Fails with "path:line: what".
Result<std::vector<server::Guest>> parse_guests(std::string_view text, const std::string& path);

/// 26 letters and digits: 130 bits of entropy from the system.
std::string random_token();

}  // namespace playhouse::web_server
