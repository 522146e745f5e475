#include "playhouse/drivers/section_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "playhouse/geom/trig.h"

namespace playhouse::drivers {
namespace {

std::string limit_text(double least) {
  return std::isfinite(least) ? fmt::format("{:.10g} at least", least) : "";
}

/// "[a b c]" of "a" or "[a b]" and "c".
std::string with_element(const std::string& before, std::string_view next) {
  if (before.ends_with(']')) return fmt::format("{} {}]", before.substr(0, before.size() - 1), next);
  return fmt::format("[{} {}]", before, next);
}

}  // namespace

double SectionFields::length(const OptionText& option, double otherwise, double least, std::size_t element) {
  tell(option, element, "length", option.unit.empty() ? "m" : option.unit, fmt::format("{:.10g}", otherwise),
       limit_text(least));
  return at_least(option.name, section_.length(option.name, otherwise, element), least);
}

double SectionFields::angle(const OptionText& option, double otherwise, std::size_t element, double least) {
  tell(option, element, "angle", option.unit.empty() ? "deg" : option.unit,
       fmt::format("{:.10g}", geom::degrees(otherwise)), limit_text(least));
  return at_least(option.name, section_.angle(option.name, otherwise, element), least);
}

double SectionFields::number(const OptionText& option, double otherwise, double least, std::size_t element) {
  tell(option, element, "number", option.unit, fmt::format("{:.10g}", otherwise), limit_text(least));
  return at_least(option.name, section_.number(option.name, otherwise, element), least);
}

int SectionFields::integer(const OptionText& option, int otherwise, int least, int most) {
  tell(option, 0, "int", option.unit, fmt::format("{}", otherwise), fmt::format("{} to {}", least, most));
  const int value = section_.integer(option.name, otherwise);
  expect(value >= least && value <= most, option.name, fmt::format("is from {} to {}", least, most));
  return value;
}

bool SectionFields::flag(const OptionText& option, bool otherwise) {
  tell(option, 0, "bool", "", otherwise ? "1" : "0", "");
  return section_.flag(option.name, otherwise);
}

std::string SectionFields::text(const OptionText& option) {
  tell(option, 0, "string", "", "\"\"", "");
  return section_.text(option.name, "");
}

std::string SectionFields::filename(const OptionText& option) {
  tell(option, 0, "filename", "", "\"\"", "");
  return section_.filename(option.name, "");
}

std::vector<int> SectionFields::integers(const OptionText& option) {
  tell(option, 0, "[int ...]", option.unit, "[]", "");
  std::vector<int> values;
  for (std::size_t i = 0; i < section_.count(option.name); ++i)
    values.push_back(section_.integer(option.name, 0, i));
  return values;
}

void SectionFields::no_effect(const OptionText& option) {
  tell(option, 0, "", "", "", "");
  section_.has(option.name);
}

void SectionFields::expect(bool good, std::string_view key, std::string_view what) {
  if (!good && !fault_) fault_ = Error{section_.at(key), fmt::format("{} {}", key, what)};
}

double SectionFields::at_least(std::string_view key, double value, double least) {
  expect(value >= least, key, fmt::format("is {} at least", least));
  return value;
}

void SectionFields::tell(const OptionText& option, std::size_t element, std::string_view type,
                         std::string_view unit, const std::string& otherwise, const std::string& limits) {
  if (told_ == nullptr) return;
  const auto known = std::ranges::find(*told_, option.name, &Option::name);
  if (known == told_->end()) {
    const bool in_words = !option.otherwise.empty();
    told_->push_back({std::string(option.name), std::string(type), std::string(unit),
                      in_words ? "" : otherwise, std::string(option.otherwise), limits,
                      std::string(option.doc)});
  } else if (element == known->elements) {
    known->elements += 1;
    known->type = with_element(known->type, type);
    if (!known->unit.empty()) known->unit += fmt::format(", {}", unit);
    if (known->told.empty()) known->otherwise = with_element(known->otherwise, otherwise);
  }
}

}  // namespace playhouse::drivers
