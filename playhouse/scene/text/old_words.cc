#include "playhouse/scene/text/old_words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/scene/text/read_word.h"
#include "playhouse/scene/text/vocabulary.h"
#include "playhouse/scene/text/write_word.h"

namespace playhouse::scene {
namespace {

constexpr double kOldInterval = 100;  // ms, default tick of old versions

/// A parsed key: `polygon[2].point[0]` is word "polygon", index 2, rest "point[0]".
struct Key {
  std::string_view word;
  std::optional<std::uint32_t> index;
  std::string_view rest;
};

Key key_of(std::string_view text) {
  const std::size_t open = text.find('['), close = text.find(']', open == std::string_view::npos ? 0 : open);
  if (open == std::string_view::npos || close == std::string_view::npos) return {text, {}, {}};
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(text.data() + open + 1, text.data() + close, index);
  std::string_view rest = text.substr(close + 1);
  if (error != std::errc{} || end != text.data() + close || (!rest.empty() && rest.front() != '.'))
    return {text, {}, {}};
  if (!rest.empty()) rest.remove_prefix(1);
  return {text.substr(0, open), index, rest};
}

/// A target: "range.1" is element 1 of the word "range"; none: the whole.
struct Target {
  std::string_view word;
  std::optional<std::size_t> element;
};

Target target_of(std::string_view text) {
  const std::size_t dot = text.find('.');
  if (dot == std::string_view::npos) return {text, {}};
  return {text.substr(0, dot), static_cast<std::size_t>(text[dot + 1] - '0')};
}

std::vector<std::string_view> split(std::string_view text, std::string_view between) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(between), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + between.size(), text.size()));
  }
  return parts;
}

double first_number(const config::Field& field) {
  return field.values.empty() ? 0 : config::parse_number(field.values.front().text).value_or(0);
}

bool is_old_interval(const config::Field& field, const Kind& kind) {
  return kind.entity == EntityForm::kWorld && field.key == "interval_real";
}

/// True for a scale in metres per pixel: Stage 4 has at least a pixel per metre.
bool is_old_scale(const config::Field& field, const Kind& kind) {
  return kind.entity == EntityForm::kWindow && field.key == "scale" && first_number(field) > 0 &&
         first_number(field) < 1;
}

}  // namespace

OldWords::OldWords(LoadState& state, const config::Macros& macros) : state_(state), macros_(macros) {
  for (const Kind& kind : kinds())
    for (const Word& word : kind.words)
      if (word.meaning) old_names_.insert(word.name);
}

config::ExpandedSection OldWords::now(config::ExpandedSection entity) {
  const OldType* const type = old_type_of(entity);
  if (type) entity.type = type->type;
  const Kind* const kind = find_entity(entity.type);
  const auto has_old = [&](const config::Section* part) { return has_old_words(part->fields, *kind); };
  if (!kind || (!type && std::ranges::none_of(entity.parts, has_old))) return entity;
  auto found = rewritten_.find(entity.parts);
  if (found == rewritten_.end())
    found = rewritten_.emplace(entity.parts, rewritten(entity, *kind, type)).first;
  entity.now = &found->second;
  return entity;
}

std::span<const config::Field> OldWords::now_of_world(std::span<const config::Field> fields) {
  if (!has_old_words(fields, world_kind())) return fields;
  world_.fields.assign(fields.begin(), fields.end());
  world_ = rewritten({world_kind().name, {&world_}, {}}, world_kind(), nullptr);
  return world_.fields;
}

const OldType* OldWords::old_type_of(const config::ExpandedSection& entity) {
  if (find_entity(entity.type)) return nullptr;
  const auto type = std::ranges::find(old_types(), entity.type, &OldType::name);
  if (type == old_types().end() || !type->is_read) return nullptr;
  state_.warnings.add_old(
      &*type, entity.parts.front()->where,
      in_quotes(type->name) + " is a type of older versions: " + std::string(type->instead));
  return &*type;
}

bool OldWords::has_old_words(std::span<const config::Field> fields, const Kind& kind) const {
  return std::ranges::any_of(fields, [&](const config::Field& field) {
    if (is_old_interval(field, kind) || is_old_scale(field, kind)) return true;
    const std::string_view name = key_of(field.key).word;
    if (!old_names_.contains(name)) return false;
    const Word* const word = find_word(kind, name);
    return word && word->meaning;
  });
}

config::Section OldWords::rewritten(const config::ExpandedSection& entity, const Kind& kind,
                                    const OldType* type) {
  Rewriting to{entity, config::FieldSet(entity.parts), kind, type, {&kind, {}}, {}};
  config::Section now{kind.name, entity.where, {}, {}};
  if (type) say(to.own, type->words, entity.where);
  if (type && !type->part.empty()) parts_of(type->part, to);
  for (const config::Field* field : to.fields.all()) {
    if (std::optional<config::Field> other = by_hand(*field, to)) {
      if (other->key == field->key || !to.fields.find(other->key)) now.fields.push_back(std::move(*other));
    } else if (state_.over || !apply(*field, to)) {
      now.fields.push_back(*field);
    }
  }
  for (const config::Field* field : to.fields.all()) check_places(*field, to);
  for (config::Field& word : to.own.words)
    if (!to.fields.find(word.key)) now.fields.push_back(std::move(word));
  for (auto& [name, parts] : to.parts) {
    if (!parts) continue;
    for (TranslatedEntity& part : *parts)
      now.sections.push_back({name, entity.where, std::move(part.words), {}});
  }
  return now;
}

bool OldWords::apply(const config::Field& field, Rewriting& to) {
  const Word* const word = find_word(to.kind, key_of(field.key).word);
  if (!word || !word->meaning) return false;
  const Meaning& meaning = *word->meaning;
  if (meaning.part.empty()) {
    apply_words(field, meaning, to.own);
  } else if (!apply_to_parts(field, meaning, to)) {
    return false;
  }
  note(field, to.kind, *word, word->instead);
  return true;
}

std::optional<config::Field> OldWords::by_hand(const config::Field& field, const Rewriting& to) {
  if (is_old_interval(field, to.kind)) {
    const config::Field* const interval = to.fields.find("interval_sim");
    const double real = first_number(field), simulated = interval ? first_number(*interval) : kOldInterval;
    const Word& word = *find_word(to.kind, field.key);
    note(field, to.kind, word, word.instead);
    return config::Field{"speedup", {number(real > 0 ? simulated / real : -1)}, field.where};
  }
  if (!is_old_scale(field, to.kind)) return std::nullopt;
  note(field, to.kind, *find_word(to.kind, field.key), "write pixels per metre, not metres per pixel");
  return config::Field{field.key, {number(1 / first_number(field))}, field.where};
}

void OldWords::check_places(const config::Field& count, const Rewriting& of) {
  const Word* const word = find_word(of.kind, count.key);
  if (!word || !word->meaning || word->meaning->how != Meaning::How::kCount) return;
  const auto parts = of.parts.find(word->meaning->part);
  if (parts == of.parts.end() || !parts->second) return;
  for (const Word& place : of.kind.words) {
    const bool is_place = place.meaning && place.meaning->part == word->meaning->part &&
                          !place.meaning->to.empty() && place.meaning->to.front() == "pose.0";
    if (!is_place || of.fields.find(place.name)) continue;
    for (std::size_t i = 0; i < parts->second->size(); ++i) {
      if (of.fields.find(numbered(place.name, i))) continue;
      return state_.warnings.add(config::Warning::kValue, count.where,
                                 in_quotes(count.key) + " is " + std::to_string(parts->second->size()) +
                                     ", but " + in_quotes(numbered(place.name, i)) +
                                     " is missing; what is missing is in the middle");
    }
  }
}

bool OldWords::apply_to_parts(const config::Field& field, const Meaning& meaning, Rewriting& to) {
  std::optional<std::vector<TranslatedEntity>>& parts = parts_of(meaning.part, to);
  if (!parts) return false;
  const Key key = key_of(field.key);
  if (meaning.how == Meaning::How::kCount) return true;
  if (key.index && *key.index >= parts->size())
    state_.warnings.add(config::Warning::kNoEffect, field.where,
                        in_quotes(field.key) + " has no effect: there are " + std::to_string(parts->size()));
  for (std::size_t i = key.index.value_or(0); i < (key.index ? *key.index + std::size_t{1} : parts->size());
       ++i) {
    if (i >= parts->size()) break;
    TranslatedEntity& part = (*parts)[i];
    if (meaning.how == Meaning::How::kWords) {
      apply_words(field, meaning, part);
    } else if (const Word* const word = find_word(*part.kind, key_of(key.rest).word);
               word && word->use == Support::kRead) {
      if (part.words.empty()) say(part, meaning.part_words, field.where);
      word_of(part, key.rest, field.where).values = field.values;
    }
  }
  return true;
}

void OldWords::apply_words(const config::Field& field, const Meaning& meaning, TranslatedEntity& to) {
  const auto meant = [&](const config::Value& old) {
    const auto other = std::ranges::find(meaning.values, old.text, &SaidWord::word);
    return other == meaning.values.end() ? old : value(other->value);
  };
  if (const Target all = target_of(meaning.to.front()); meaning.to.size() == 1 && !all.element) {
    config::Field& word = word_of(to, all.word, field.where);
    word.values.clear();
    for (const config::Value& old : field.values) word.values.push_back(meant(old));
    return;
  }
  for (std::size_t i = 0; i < std::min(meaning.to.size(), field.values.size()); ++i) {
    const Target target = target_of(meaning.to[i]);
    if (target.word.empty()) continue;
    config::Field& word = word_of(to, target.word, field.where);
    const std::size_t element = target.element.value_or(0);
    if (word.values.size() <= element) {
      const Word* const known = find_word(*to.kind, target.word);
      std::vector<config::Value> otherwise = values(*to.kind, target.word, known ? known->otherwise : "");
      otherwise.resize(std::max(otherwise.size(), element + 1), value("0"));
      std::ranges::copy(word.values, otherwise.begin());
      word.values = std::move(otherwise);
    }
    word.values[element] = meant(field.values[i]);
  }
}

std::optional<std::vector<OldWords::TranslatedEntity>>& OldWords::parts_of(std::string_view part,
                                                                           Rewriting& to) {
  const auto [found, is_new] = to.parts.try_emplace(part);
  std::optional<std::vector<TranslatedEntity>>& parts = found->second;
  if (!is_new || has_parts(to.entity, part)) return parts;
  const Kind* const kind = find_entity(part);
  parts.emplace(count_parts(part, to), TranslatedEntity{kind, {}});
  for (TranslatedEntity& each : *parts)
    if (to.type && to.type->part == part) say(each, to.type->part_words, to.entity.where);
  return parts;
}

/// Aborts the load if there are too many.
std::size_t OldWords::count_parts(std::string_view part, const Rewriting& of) {
  double count = of.type && of.type->part == part ? 1 : 0;
  config::SourceLine where = of.entity.where;
  bool is_counted = false;
  for (const config::Field* field : of.fields.all()) {
    const Key key = key_of(field->key);
    const Word* const word = find_word(of.kind, key.word);
    if (!word || !word->meaning || word->meaning->part != part) continue;
    if (word->meaning->how == Meaning::How::kCount) {
      count = std::max(0.0, std::floor(first_number(*field)));
      where = field->where;
      is_counted = true;
    } else if (!is_counted) {
      const bool is_about_all = !key.index && word->meaning->how == Meaning::How::kWords;
      count = std::max(count, key.index ? *key.index + 1.0 : is_about_all ? 1.0 : 0.0);
    }
  }
  const double room = static_cast<double>(limits::kOldParts - parts_);
  if (count > std::min(room, static_cast<double>(limits::kOldPartsOfOne))) {
    state_.end(state_.document.error(where, "old words tell of too many parts of a model, or of all models"));
    return 0;
  }
  parts_ += static_cast<std::size_t>(count);
  return static_cast<std::size_t>(count);
}

bool OldWords::has_parts(const config::ExpandedSection& entity, std::string_view part) const {
  for (const config::Section* body : entity.parts)
    for (const config::Section& section : body->sections)
      if (const Result<config::ExpandedSection> inner = macros_.instance(section);
          inner && inner->type == part)
        return true;
  return false;
}

config::Field& OldWords::word_of(TranslatedEntity& entity, std::string_view name, config::SourceLine where) {
  const auto found = std::ranges::find(entity.words, name, &config::Field::key);
  if (found != entity.words.end()) return *found;
  return entity.words.emplace_back(config::Field{name, {}, where});
}

void OldWords::say(TranslatedEntity& entity, std::span<const SaidWord> words, config::SourceLine where) {
  for (const SaidWord& said : words)
    word_of(entity, said.word, where).values = values(*entity.kind, said.word, said.value);
}

void OldWords::note(const config::Field& field, const Kind& kind, const Word& word,
                    std::string_view instead) {
  const std::string told = in_quotes(word.name) + " of " + owner_of(kind);
  state_.warnings.add_old(&word, field.where, told + " is of older versions: " + std::string(instead));
}

config::Value OldWords::value(std::string_view text) const {
  return {config::parse_number(text) ? config::ValueKind::kNumber : config::ValueKind::kString, text};
}

config::Value OldWords::number(double number) {
  return {config::ValueKind::kNumber, texts_.emplace_back(number_text(number))};
}

std::vector<config::Value> OldWords::values(const Kind& kind, std::string_view word, std::string_view text) {
  if (text.starts_with('[')) text = text.substr(1, text.size() - 2);
  const Word* const known = find_word(kind, word);
  const std::vector<std::string_view> units = split(known ? known->unit : "", ", ");
  std::vector<config::Value> all;
  for (const std::string_view each : split(text, " ")) {
    const std::string_view unit = units.empty() ? "" : units[std::min(all.size(), units.size() - 1)];
    const double scale = unit == "m"     ? 1 / state_.units.length
                         : unit == "deg" ? geom::kPi / 180 / state_.units.angle
                                         : 1;
    const std::optional<double> plain = config::parse_number(each);
    all.push_back(plain && scale != 1 ? number(*plain * scale) : value(each));
  }
  return all;
}

}  // namespace playhouse::scene
