#pragma once

#include <string>
#include <string_view>

namespace playhouse {

/// Quotes untrusted text for messages: control characters and invalid UTF-8 as
/// \xNN, against forged log lines, truncated with "..." if longer than a line.
std::string in_quotes(std::string_view text);

/// Escapes untrusted text that is shown unquoted,
/// such as a file name: likewise, but not truncated.
std::string escaped(std::string_view text);

}  // namespace playhouse
