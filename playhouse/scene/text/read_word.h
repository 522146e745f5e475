#pragma once

/// Readers of single words beyond those of Properties, called by the
/// generated readers of entities (generated/read_kinds.h).
/// `otherwise` is the default; errors are recorded in the LoadState.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/properties.h"

namespace playhouse::scene {

/// Records an error, `"key" what`, with the value of a word that has one, unless `good`.
void require(bool good, const Properties& properties, std::string_view key, std::string_view what);

/// Clamps a negative value to 0 with a warning; `meant` explains what 0 means.
double at_least_zero(const Properties& properties, std::string_view key, double value,
                     std::string_view meant);
int at_least_zero(const Properties& properties, std::string_view key, int value, std::string_view meant);

/// An integer from `least` to `most`; anything else is an error.
std::uint32_t read_count(const Properties& properties, std::string_view key, std::uint32_t otherwise,
                         std::uint32_t least, std::uint32_t most);

/// Converts milliseconds to seconds, rounded to microseconds.
double read_milliseconds(const Properties& properties, std::string_view key, double otherwise);

/// Index in `words` of the value; an unknown one is an error.
std::size_t read_choice(const Properties& properties, std::string_view key,
                        std::span<const std::string_view> words, std::size_t otherwise);

/// One element of a tuple of choices.
struct Choice {
  std::string_view name;
  std::span<const std::string_view> words;
  std::size_t value = 0;  // index of the value
};

/// Reads a tuple of choices; missing or unknown
/// values are errors. `form` as in "[paddles lift]".
void read_choices(const Properties& properties, std::string_view key, std::span<Choice> choices,
                  std::string_view form);

/// All non-empty texts of a tuple.
std::vector<std::string> read_texts(const Properties& properties, std::string_view key);

/// The colours of a tuple of names; unknown names are dropped with a warning.
std::vector<Color> read_colors(const Properties& properties, std::string_view key);

/// An error, with the nearest known one, unless `name` is a material of materials.h.
void known_material(const Properties& properties, std::string_view key, std::string_view name);

/// A warning if `name` is not a material but similar to one: other names are properties for detectors.
void not_misspelt_material(const Properties& properties, std::string_view key, std::string_view name);

/// An error unless `text` is empty or the bytes of an id (forms/tag_id.h).
void hexadecimal_bytes(const Properties& properties, std::string_view key, std::string_view text);

/// [x y], unscaled.
geom::Vec2 read_point(const Properties& properties, std::string_view key, geom::Vec2 otherwise);

/// Four numbers scaled by `scales` (Properties::tuple); three omit z, as in Stage 2.
geom::Twist read_twist(const Properties& properties, std::string_view key, std::string_view scales,
                       std::string_view form);

/// Minimum and maximum of each axis; a minimum above the maximum is an error.
void read_bounds(const Properties& properties, std::string_view key, std::string_view scales,
                 Interval (&bounds)[4]);

/// The key word[index].
std::string numbered(std::string_view word, std::size_t index);

/// Warns of word[i] beyond `count`, the value of the word `counted_by`.
void warn_of_uncounted(const Properties& properties, std::string_view word, std::string_view counted_by,
                       std::uint32_t count);

/// The same; also warns of the first missing one, if there is no `word` as a default.
void check_numbered(const Properties& properties, std::string_view word, std::string_view counted_by,
                    std::uint32_t count);

/// Reads word[0], word[1], ...: `count` of them. `read(key, value)` reads
/// one; missing ones default to `word` without an index, then to `otherwise`.
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
