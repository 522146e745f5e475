#include "playhouse/scene/text/condition.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/scene/kinds.h"

namespace playhouse::scene {
namespace {

using Compare = Term::Compare;

/// Value type of a property.
enum class Form : std::uint8_t { kText, kKind, kColor, kSwitch, kNumber };

struct Row {
  std::string_view name;
  Property property;
  Form form;
};
constexpr Row kProperties[] = {
    {"name", Property::kName, Form::kText},
    {"material", Property::kMaterial, Form::kText},
    {"says", Property::kSays, Form::kText},
    {"kind", Property::kKind, Form::kKind},
    {"color", Property::kColor, Form::kColor},
    {"light", Property::kLight, Form::kSwitch},
    {"speed", Property::kSpeed, Form::kNumber},
    {"fiducial_return", Property::kFiducialReturn, Form::kNumber},
    {"ranger_return", Property::kRangerReturn, Form::kNumber},
    {"gripper_return", Property::kGripperReturn, Form::kNumber},
    {"obstacle_return", Property::kObstacleReturn, Form::kNumber},
    {"mass", Property::kMass, Form::kNumber},
};

/// Splits off the next term: up to a space outside single quotes, which are removed.
Result<std::string> next_term(std::string_view& text) {
  std::string term;
  bool quoted = false;
  std::size_t at = 0;
  for (; at < text.size() && (quoted || text[at] != ' '); ++at) {
    if (text[at] == '\'') {
      quoted = !quoted;
    } else {
      term += text[at];
    }
  }
  if (quoted) return Error{{}, "lacks a closing ' in " + in_quotes(text)};
  text.remove_prefix(std::min(text.find_first_not_of(' ', at), text.size()));
  return term;
}

std::string unknown(std::string_view what, std::string_view word, std::span<const std::string_view> words) {
  return "has an unknown " + std::string(what) + " " + in_quotes(word) + did_you_mean(word, words);
}

Result<ModelKind> kind_of(std::string_view word) {
  std::vector<std::string_view> names;
  for (const Kind& kind : kinds()) {
    if (kind.entity != EntityForm::kModel || !kind.simulated) continue;
    if (kind.name == word) return kind.kind;
    names.push_back(kind.name);
  }
  return Error{{}, unknown("kind", word, names)};
}

std::optional<std::uint32_t> rgb_of(std::string_view word) {
  std::uint32_t rgb = 0;
  if (word.size() == 7 && word.front() == '#') {
    const auto [end, fault] = std::from_chars(word.data() + 1, word.data() + 7, rgb, 16);
    if (fault == std::errc() && end == word.data() + 7) return rgb;
  }
  const std::optional<Color> color = color_by_name(word);
  if (!color) return std::nullopt;
  return rgba8(*color) >> 8;
}

Result<void> read_value(const Row& row, std::string_view value, Term& term) {
  switch (row.form) {
    case Form::kText:
      term.prefix = value.ends_with('*');
      term.text = value.substr(0, value.size() - (term.prefix ? 1 : 0));
      return {};
    case Form::kKind: {
      const Result<ModelKind> kind = kind_of(value);
      if (!kind) return kind.error();
      term.kind = *kind;
      return {};
    }
    case Form::kColor: {
      const std::optional<std::uint32_t> rgb = rgb_of(value);
      if (!rgb) return Error{{}, "has an unknown color " + in_quotes(value) + color_hint(value)};
      term.rgb = *rgb;
      return {};
    }
    case Form::kSwitch:
      if (value != "on" && value != "off")
        return Error{{}, "needs " + std::string(row.name) + "=on or =off, found " + in_quotes(value)};
      term.number = 1;
      if (value == "off") term.compare = term.compare == Compare::kIs ? Compare::kIsNot : Compare::kIs;
      return {};
    case Form::kNumber: {
      const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), term.number);
      if (fault == std::errc() && end == value.data() + value.size()) return {};
      return Error{{}, "needs a number behind " + in_quotes(row.name) + ", found " + in_quotes(value)};
    }
  }
  return {};
}

Result<Term> read_term(std::string_view text) {
  const std::size_t sign = std::min(text.find_first_of("=!<>"), text.size());
  const std::string_view name = text.substr(0, sign);
  const auto row = std::ranges::find(kProperties, name, &Row::name);
  if (row == std::end(kProperties)) return Error{{}, unknown("property", name, property_names())};
  Term term{.property = row->property, .text = {}};
  const bool is_not = text.substr(sign).starts_with("!=");
  const std::string_view value = text.substr(std::min(text.size(), sign + (is_not ? 2 : 1)));
  if (sign == text.size() || (text[sign] == '!' && !is_not))
    return Error{{}, "needs =, !=, < or > behind " + in_quotes(name)};
  if (is_not) term.compare = Compare::kIsNot;
  if (text[sign] == '<') term.compare = Compare::kBelow;
  if (text[sign] == '>') term.compare = Compare::kAbove;
  if ((text[sign] == '<' || text[sign] == '>') && row->form != Form::kNumber)
    return Error{{}, in_quotes(name) + " is not a number: it has = and != only"};
  if (const Result<void> read = read_value(*row, value, term); !read) return read.error();
  return term;
}

}  // namespace

std::vector<std::string_view> property_names() {
  std::vector<std::string_view> names;
  for (const Row& row : kProperties) names.push_back(row.name);
  return names;
}

Result<Condition> read_condition(std::string_view text) {
  Condition condition;
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  while (!text.empty()) {
    const Result<std::string> next = next_term(text);
    if (!next) return next.error();
    Result<Term> term = read_term(*next);
    if (!term) return term.error();
    condition.push_back(std::move(*term));
  }
  if (condition.empty()) return Error{{}, "has a condition without a term"};
  return condition;
}

}  // namespace playhouse::scene
