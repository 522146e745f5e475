#pragma once

#include <span>
#include <string>
#include <string_view>

namespace playhouse {

/// The candidate with the smallest edit distance to `word`, or "" when none is near (distance over a third of
/// the word's length, at least 2). Capitals are as near as small letters. Ties go to the first.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

/// " (did you mean "x"?)", or "" when nothing is near: the tail of an error line.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace playhouse
