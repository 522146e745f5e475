#pragma once

/// Translates worlds of Stage 1 to 3 to current words before they are interpreted:
/// entities with old types or words are rewritten by the tables `[old]` and
/// `[old_types]` of kinds/*.toml. One warning per old word. Two translations are
/// hard-coded: `interval_real` of the world, and a window's scale in metres per pixel.

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/kinds.h"
#include "playhouse/scene/properties.h"

namespace playhouse::scene {

class OldWords {
 public:
  OldWords(LoadState& state, const config::Macros& macros);

  /// The entity in current words. Its type is "" if it is dropped.
  config::ExpandedSection now(config::ExpandedSection entity);
  /// The words of the world, translated.
  std::span<const config::Field> now_of_world(std::span<const config::Field> fields);

 private:
  /// Translated words of the entity being made, or of one of its parts.
  struct TranslatedEntity {
    const Kind* kind = nullptr;
    std::vector<config::Field> words;
  };
  struct Rewriting {
    const config::ExpandedSection& entity;
    const config::FieldSet fields;
    const Kind& kind;
    const OldType* type;
    TranslatedEntity own;
    /// By type; none if the entity has such parts in current words.
    std::map<std::string_view, std::optional<std::vector<TranslatedEntity>>> parts;
  };

  const OldType* old_type_of(const config::ExpandedSection& entity);
  bool has_old_words(std::span<const config::Field> fields, const Kind& kind) const;
  config::Section rewritten(const config::ExpandedSection& entity, const Kind& kind, const OldType* type);
  /// False: the field is left as it is.
  bool apply(const config::Field& field, Rewriting& to);
  /// Warns of parts that `count` announces but that have no pose.
  void check_places(const config::Field& count, const Rewriting& of);
  bool apply_to_parts(const config::Field& field, const Meaning& meaning, Rewriting& to);
  void apply_words(const config::Field& field, const Meaning& meaning, TranslatedEntity& to);
  /// Hard-coded translations.
  std::optional<config::Field> by_hand(const config::Field& field, const Rewriting& to);
  std::optional<std::vector<TranslatedEntity>>& parts_of(std::string_view part, Rewriting& to);
  std::size_t count_parts(std::string_view part, const Rewriting& of);
  bool has_parts(const config::ExpandedSection& entity, std::string_view part) const;

  /// The word of that name, added if missing.
  config::Field& word_of(TranslatedEntity& entity, std::string_view name, config::SourceLine where);
  void say(TranslatedEntity& entity, std::span<const SaidWord> words, config::SourceLine where);
  void note(const config::Field& field, const Kind& kind, const Word& word, std::string_view instead);

  config::Value value(std::string_view text) const;
  config::Value number(double number);
  /// Parses values of a definition, "[0 8]", into the units of the file.
  std::vector<config::Value> values(const Kind& kind, std::string_view word, std::string_view text);

  LoadState& state_;
  const config::Macros& macros_;
  std::set<std::string_view> old_names_;  // all translated words
  std::map<std::vector<const config::Section*>, config::Section>
      rewritten_;                  // cache, keyed by the bodies of an entity
  std::deque<std::string> texts_;  // storage of generated values
  config::Section world_;
  std::size_t parts_ = 0;  // created so far
};

}  // namespace playhouse::scene
