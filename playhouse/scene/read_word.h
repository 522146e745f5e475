#pragma once

/// How single words are read that Properties has no function for. The functions that read whole entities are
/// generated from kinds/*.toml (generated/read_kinds.h) and call these. `otherwise` is what counts without
/// the word; faults are kept in the state of the load.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/properties.h"

namespace playhouse::scene {

/// A fault of `key`, `"key" what`, unless it is good.
void require(bool good, const Properties& properties, std::string_view key, std::string_view what);

/// The value, or 0 and a warning where it is below; `meant` says what 0 is.
double at_least_zero(const Properties& properties, std::string_view key, double value,
                     std::string_view meant);
int at_least_zero(const Properties& properties, std::string_view key, int value, std::string_view meant);

/// A whole number from `least` to `most`; others are a fault.
std::uint32_t read_count(const Properties& properties, std::string_view key, std::uint32_t otherwise,
                         std::uint32_t least, std::uint32_t most);

/// Milliseconds as seconds, a whole number of microseconds.
double read_milliseconds(const Properties& properties, std::string_view key, double otherwise);

/// Which of `words` the file has; none of them is a fault.
std::size_t read_choice(const Properties& properties, std::string_view key,
                        std::span<const std::string_view> words, std::size_t otherwise);

/// One of several choices of a word.
struct Choice {
  std::string_view name;
  std::span<const std::string_view> words;
  std::size_t value = 0;  // which of them
};

/// Which words the file has, in the order of `choices`; fewer than that, and none of them, is a fault. `form`
/// is as in "[paddles lift]".
void read_choices(const Properties& properties, std::string_view key, std::span<Choice> choices,
                  std::string_view form);

/// All texts of a tuple but empty ones.
std::vector<std::string> read_texts(const Properties& properties, std::string_view key);

/// The colors of all names of a tuple; those of unknown names are left out with a warning.
std::vector<Color> read_colors(const Properties& properties, std::string_view key);

/// [x y], as they are.
geom::Vec2 read_point(const Properties& properties, std::string_view key, geom::Vec2 otherwise);

/// Four numbers, as `scales` says (Properties::tuple); three leave z out, as Stage 2 did.
geom::Twist read_twist(const Properties& properties, std::string_view key, std::string_view scales,
                       std::string_view form);

/// A minimum and a maximum of each axis; a minimum above its maximum is a fault.
void read_bounds(const Properties& properties, std::string_view key, std::string_view scales,
                 Bounds (&bounds)[4]);

/// The key of word[index].
std::string numbered(std::string_view word, std::size_t index);

/// Warns of word[i] that is not among the first `count`, which the word `counted_by` says.
void warn_of_uncounted(const Properties& properties, std::string_view word, std::string_view counted_by,
                       std::uint32_t count);

/// The same, and warns of the first that is missing where there is no `word` for all.
void check_numbered(const Properties& properties, std::string_view word, std::string_view counted_by,
                    std::uint32_t count);

/// word[0], word[1], ...: `count` of them. `read(key, value)` reads one; where there is none, `word` without
/// a number counts, else `otherwise`.
template <typename Value, typename Read>
std::vector<Value> read_each(const Properties& properties, std::string_view word, std::string_view counted_by,
                             std::uint32_t count, Value otherwise, const Read& read) {
  read(word, otherwise);
  std::vector<Value> values(count, otherwise);
  for (std::uint32_t i = 0; i < count; ++i) read(numbered(word, i), values[i]);
  check_numbered(properties, word, counted_by, count);
  return values;
}

}  // namespace playhouse::scene
