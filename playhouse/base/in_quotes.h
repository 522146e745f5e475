#pragma once

#include <string>
#include <string_view>

namespace playhouse {

/// Text from outside as our messages show it: in quotes, control characters and bytes that are no UTF-8 as
/// \xNN so that nobody forges lines of a log, and cut with "..." when it is longer than a line.
std::string in_quotes(std::string_view text);

/// Text from outside that stands without quotes, as a file's name before its line or a sentence: the same,
/// and whole.
std::string escaped(std::string_view text);

}  // namespace playhouse
