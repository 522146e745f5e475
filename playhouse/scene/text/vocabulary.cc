#include "playhouse/scene/text/vocabulary.h"

#include <algorithm>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/scene/text/write_word.h"

namespace playhouse::scene {
namespace {

std::string hint(const Kind& kind, std::string_view word) {
  std::vector<std::string_view> candidates = {"include"};
  if (kind.entity == EntityForm::kWorld) candidates.push_back("define");
  for (const std::span<const Word> words : {common_words(kind), kind.words}) {
    for (const Word& known : words) {
      if (known.use != Support::kOld) candidates.push_back(known.name);
    }
  }
  return did_you_mean(word, candidates);
}

}  // namespace

std::string owner_of(const Kind& kind) {
  return (kind.entity == EntityForm::kWorld ? "the " : "") + std::string(kind.name);
}

std::string what_instead(std::string_view name, std::span<const std::string_view> others) {
  const auto old = std::ranges::find(old_types(), name, &OldType::name);
  if (old != old_types().end()) return " (Stage 4 has none: " + std::string(old->instead) + ")";
  std::vector<std::string_view> candidates;
  for (const Kind& kind : kinds()) {
    if (find_entity(kind.name)) candidates.push_back(kind.name);
  }
  candidates.insert(candidates.end(), others.begin(), others.end());
  return did_you_mean(name, candidates);
}

std::string place_of(const Kind& kind) {
  return kind.entity == EntityForm::kPart ? "a " + std::string(kind.inside)
                                          : "no model, but at the top level";
}

std::vector<KeptWord> kept_words(const Kind& kind, const Properties& properties) {
  std::vector<KeptWord> kept;
  for (const config::Field* field : properties.fields().all()) {
    const Word* word = find_word(kind, config::without_index(field->key));
    if (!word || (word->use != Support::kSilent && word->use != Support::kLater) || field->values.empty())
      continue;
    std::vector<std::string> values;
    for (const config::Value& value : field->values) {
      const std::optional<double> number =
          value.kind == config::ValueKind::kNumber ? config::parse_number(value.text) : std::nullopt;
      values.push_back(number ? number_text(*number) : quoted_text(value.text));
    }
    kept.push_back({std::string(field->key), values.size() == 1 ? values.front() : in_brackets(values)});
  }
  return kept;
}

void VocabularyCheck::check(const Kind& kind, const Properties& properties) {
  LoadState& state = properties.state();
  for (const config::Field* field : properties.fields().all()) {
    if (!checked_.insert(field).second) continue;  // a macro's field is checked once
    const std::string_view name = config::without_index(field->key);
    const Word* word = find_word(kind, name);
    if (word && word->use != Support::kLater && word->use != Support::kOld) continue;
    if (word && word->use == Support::kLater && !words_.insert(name).second) continue;
    const std::string subject = in_quotes(name);
    const std::string whose = " of " + owner_of(kind);
    if (!word) {
      state.warnings.add(config::Warning::kUnknownWord, field->where, "unknown property " + subject + whose,
                         [&] { return hint(kind, name); });
    } else if (word->use == Support::kLater) {
      state.warnings.add(config::Warning::kNoEffect, field->where,
                         subject + " is not simulated yet and has no effect");
    } else {
      const std::string instead = word->instead.empty() ? "" : ": " + std::string(word->instead);
      state.warnings.add_old(word, field->where, subject + whose + " has no effect" + instead);
    }
  }
}

}  // namespace playhouse::scene
