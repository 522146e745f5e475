#include "playhouse/config/text/expand.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::config {
namespace {

struct Unit {
  std::string_view name, also;  // as in the file, and a likely correction
  double factor;
};
constexpr Unit kLengths[] = {{"m", "metres", 1}, {"cm", "centimetres", 0.01}, {"mm", "millimetres", 0.001}};
constexpr Unit kAngles[] = {{"degrees", "deg", geom::kPi / 180}, {"radians", "rad", 1}};

std::string_view word_of(std::span<const Unit> units, double factor) {
  return std::ranges::find(units, factor, &Unit::factor)->name;
}

}  // namespace

bool Macros::define(const Statement& statement) {
  return macros_.emplace(statement.section.name, &statement).second;
}

const Statement* Macros::find(std::string_view name) const {
  const auto found = macros_.find(name);
  return found == macros_.end() ? nullptr : found->second;
}

std::vector<std::string_view> Macros::names() const {
  std::vector<std::string_view> names;
  for (const auto& [name, statement] : macros_) names.push_back(name);
  return names;
}

Result<ExpandedSection> Macros::instance(const Section& section) const {
  ExpandedSection instance{section.name, {&section}, section.where};
  while (const Statement* macro = find(instance.type)) {
    if (instance.parts.size() > static_cast<std::size_t>(limits::kEntityDepth)) {
      return document_.error(section.where, "macro " + in_quotes(section.name) +
                                                " is based on itself, or on more than " +
                                                std::to_string(limits::kEntityDepth) + " others");
    }
    instance.parts.push_back(&macro->section);
    instance.type = macro->base;
  }
  std::reverse(instance.parts.begin(), instance.parts.end());
  return instance;
}

FieldSet::FieldSet(const ExpandedSection& instance)
    : FieldSet(instance.now ? std::span(&instance.now, 1) : std::span(instance.parts)) {}

FieldSet::FieldSet(std::span<const Section* const> parts) {
  for (const Section* part : parts) {
    for (const Field& field : part->fields) fields_.push_back(&field);
  }
  keep_last_of_each();
}

FieldSet::FieldSet(std::span<const Field> fields) {
  for (const Field& field : fields) fields_.push_back(&field);
  keep_last_of_each();
}

void FieldSet::keep_last_of_each() {
  std::stable_sort(fields_.begin(), fields_.end(),
                   [](const Field* a, const Field* b) { return a->key < b->key; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (i + 1 == fields_.size() || fields_[i + 1]->key != fields_[i]->key) fields_[kept++] = fields_[i];
  }
  fields_.resize(kept);
}

const Field* FieldSet::find(std::string_view key) const {
  const auto found = std::lower_bound(fields_.begin(), fields_.end(), key,
                                      [](const Field* field, std::string_view k) { return field->key < k; });
  return found != fields_.end() && (*found)->key == key ? *found : nullptr;
}

Result<Units> read_units(const Document& document, const FieldSet& fields) {
  const auto read = [&](std::string_view key, std::span<const Unit> units, double& factor) -> Result<void> {
    const Field* field = fields.find(key);
    if (!field) return {};
    const std::string_view name = field->values.empty() ? std::string_view{} : field->values.front().text;
    std::vector<std::string_view> names;
    std::string choices;
    for (const Unit& unit : units) {
      if (unit.name == name) {
        factor = unit.factor;
        return {};
      }
      names.insert(names.end(), {unit.name, unit.also});
      choices += (choices.empty() ? "" : ", ") + in_quotes(unit.name);
    }
    std::string hint;
    const std::string_view nearest = nearest_word(name, names);
    for (const Unit& unit : units) {
      if (!nearest.empty() && (nearest == unit.name || nearest == unit.also))
        hint = " (did you mean " + in_quotes(unit.name) + "?)";
    }
    return document.error(field->where,
                          std::string(key) + " is one of " + choices + ", found " + in_quotes(name) + hint);
  };
  Units units;
  if (const auto length = read("unit_length", kLengths, units.length); !length) return length.error();
  if (const auto angle = read("unit_angle", kAngles, units.angle); !angle) return angle.error();
  return units;
}

std::string_view length_word(const Units& units) {
  return word_of(kLengths, units.length);
}

std::string_view angle_word(const Units& units) {
  return word_of(kAngles, units.angle);
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  const std::string_view digits = text.starts_with('-') ? text.substr(1) : text;
  if (digits.empty() || (digits.front() != '.' && (digits.front() < '0' || digits.front() > '9'))) {
    return std::nullopt;  // from_chars also accepts "inf" and "nan"
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || std::abs(value) > 1e300)
    return std::nullopt;
  return value;
}

std::string_view without_index(std::string_view key) {
  const std::size_t open = key.find('[');
  if (open == std::string_view::npos || !key.ends_with(']')) return key;
  const std::string_view index = key.substr(open + 1, key.size() - open - 2);
  const bool digits = !index.empty() && index.find_first_not_of("0123456789") == std::string_view::npos;
  return digits ? key.substr(0, open) : key;
}

}  // namespace playhouse::config
