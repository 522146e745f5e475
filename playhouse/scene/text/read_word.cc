#include "playhouse/scene/text/read_word.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/scene/forms/materials.h"
#include "playhouse/scene/forms/tag_id.h"

namespace playhouse::scene {
namespace {

constexpr std::string_view kBoundsForm = "[xmin xmax ymin ymax zmin zmax amin amax]";

template <typename Number>
Number raised_to_zero(const Properties& properties, std::string_view key, Number value,
                      std::string_view meant) {
  if (value >= 0) return value;
  properties.state().warnings.add(config::Warning::kValue, properties.where(key),
                                  in_quotes(key) + " is below 0; " + std::string(meant));
  return 0;
}

/// Index of a value in `words`; an unknown one is an error of `key`, or of `part` of it.
std::size_t chosen(const Properties& properties, std::string_view key, std::string_view part,
                   std::span<const std::string_view> words, std::string_view word, std::size_t otherwise) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string known;
  for (const std::string_view w : words) known += (known.empty() ? "" : ", ") + in_quotes(w);
  const std::string of = part.empty() ? in_quotes(key) : std::string(part) + " of " + in_quotes(key);
  properties.state().fail(properties.where(key), of + " is one of " + known + ", found " + in_quotes(word) +
                                                     did_you_mean(word, words));
  return otherwise;
}

}  // namespace

void require(bool good, const Properties& properties, std::string_view key, std::string_view what) {
  if (good) return;
  const config::Field* const field = properties.fields().find(key);
  const bool is_single = field && field->values.size() == 1;
  properties.state().fail(properties.where(key),
                          in_quotes(key) + " " + std::string(what) +
                              (is_single ? ", found " + in_quotes(field->values.front().text) : ""));
}

double at_least_zero(const Properties& properties, std::string_view key, double value,
                     std::string_view meant) {
  return raised_to_zero(properties, key, value, meant);
}

int at_least_zero(const Properties& properties, std::string_view key, int value, std::string_view meant) {
  return raised_to_zero(properties, key, value, meant);
}

std::uint32_t read_count(const Properties& properties, std::string_view key, std::uint32_t otherwise,
                         std::uint32_t least, std::uint32_t most) {
  const std::int64_t value =
      properties.has(key) ? properties.integer(key, static_cast<int>(otherwise)) : std::int64_t{otherwise};
  const bool good = value >= least && value <= most;
  require(good, properties, key, "must be from " + std::to_string(least) + " to " + std::to_string(most));
  return good ? static_cast<std::uint32_t>(value) : least;
}

double read_milliseconds(const Properties& properties, std::string_view key, double otherwise) {
  if (!properties.has(key)) return otherwise;
  return std::round(properties.number(key, otherwise * 1000) * 1000) / 1e6;
}

std::size_t read_choice(const Properties& properties, std::string_view key,
                        std::span<const std::string_view> words, std::size_t otherwise) {
  if (!properties.has(key)) return otherwise;
  return chosen(properties, key, "", words, properties.text(key, words.front()), otherwise);
}

void read_choices(const Properties& properties, std::string_view key, std::span<Choice> choices,
                  std::string_view form) {
  const std::span<const config::Value> values = properties.elements(key, choices.size(), form);
  for (std::size_t i = 0; i < values.size(); ++i)
    choices[i].value =
        chosen(properties, key, choices[i].name, choices[i].words, values[i].text, choices[i].value);
}

std::vector<std::string> read_texts(const Properties& properties, std::string_view key) {
  std::vector<std::string> texts = properties.texts(key);
  std::erase(texts, "");
  return texts;
}

std::vector<Color> read_colors(const Properties& properties, std::string_view key) {
  std::vector<Color> colors;
  for (const std::string& name : read_texts(properties, key)) {
    if (const std::optional<Color> known = color_by_name(name)) {
      colors.push_back(*known);
    } else {
      properties.state().warnings.add(config::Warning::kColor, properties.where(key),
                                      "unknown color " + in_quotes(name) + ", it is left out",
                                      [&name] { return color_hint(name); });
    }
  }
  return colors;
}

void known_material(const Properties& properties, std::string_view key, std::string_view name) {
  if (is_material(name)) return;
  properties.state().fail(properties.where(key), in_quotes(key) + " " + in_quotes(name) +
                                                     " is not a known material" +
                                                     did_you_mean(name, material_names()));
}

void not_misspelt_material(const Properties& properties, std::string_view key, std::string_view name) {
  if (name.empty() || is_material(name) || name == kSmoke) return;
  const std::string hint = did_you_mean(name, material_names());
  if (hint.empty()) return;
  properties.state().warnings.add(config::Warning::kValue, properties.where(key),
                                  in_quotes(key) + " " + in_quotes(name) +
                                      " is a property for detectors only, not a known material" + hint);
}

void hexadecimal_bytes(const Properties& properties, std::string_view key, std::string_view text) {
  require(text.empty() || tag_id(text), properties, key,
          "must be 1 to " + std::to_string(kTagIdBytes) +
              " bytes as pairs of hexadecimal digits, as \"E200 3412\"");
}

geom::Vec2 read_point(const Properties& properties, std::string_view key, geom::Vec2 otherwise) {
  double v[2] = {otherwise.x, otherwise.y};
  properties.tuple(key, "NN", v, "[x y]");
  return {v[0], v[1]};
}

geom::Twist read_twist(const Properties& properties, std::string_view key, std::string_view scales,
                       std::string_view form) {
  double v[4] = {};
  if (properties.is_flat(key, 3, form)) {
    const std::string flat{scales[0], scales[1], scales[3]};
    properties.tuple(key, flat, v, "");
    return {v[0], v[1], 0, v[2]};
  }
  properties.tuple(key, scales, v, form);
  return {v[0], v[1], v[2], v[3]};
}

void read_bounds(const Properties& properties, std::string_view key, std::string_view scales,
                 Interval (&bounds)[4]) {
  std::array<double, 8> v;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    v[2 * axis] = bounds[axis].min;
    v[2 * axis + 1] = bounds[axis].max;
  }
  properties.tuple(key, scales, v, kBoundsForm);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    bounds[axis] = {v[2 * axis], v[2 * axis + 1]};
    require(bounds[axis].min <= bounds[axis].max, properties, key, "has a minimum above its maximum");
  }
}

std::string numbered(std::string_view word, std::size_t index) {
  return std::string(word) + "[" + std::to_string(index) + "]";
}

void warn_of_uncounted(const Properties& properties, std::string_view word, std::string_view counted_by,
                       std::uint32_t count) {
  const auto is_counted = [&](std::string_view key) {
    std::uint32_t i = count;
    std::from_chars(key.data() + word.size() + 1, key.data() + key.size(), i);
    return i < count && key == numbered(word, i);
  };
  for (const config::Field* field : properties.fields().all()) {
    if (field->key == word || config::without_index(field->key) != word || is_counted(field->key)) continue;
    properties.state().warnings.add(
        config::Warning::kNoEffect, field->where,
        in_quotes(field->key) + " has no effect: " + in_quotes(counted_by) + " is " + std::to_string(count));
  }
}

void check_numbered(const Properties& properties, std::string_view word, std::string_view counted_by,
                    std::uint32_t count) {
  warn_of_uncounted(properties, word, counted_by, count);
  if (properties.has(word)) return;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (properties.has(numbered(word, i))) continue;
    properties.state().warnings.add(config::Warning::kValue, properties.where(counted_by),
                                    in_quotes(counted_by) + " is " + std::to_string(count) + ", but " +
                                        in_quotes(numbered(word, i)) +
                                        " is missing; what is missing is as by default");
    return;
  }
}

}  // namespace playhouse::scene
