#pragma once

#include <span>
#include <string>
#include <string_view>

namespace playhouse {

/// The candidate with the smallest edit distance to `word`, case-insensitive; ""
/// if that exceeds a third of the word's length, at least 2. Ties go to the first.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

/// Suggestion for an error message: " (did you mean "x"?)", or "".
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace playhouse
