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
  OldWords(LoadState& state, const Macros& macros);

  /// The entity in current words. Its type is "" if it is dropped.
  ExpandedSection now(ExpandedSection entity);
  /// The words of the world, translated.
  std::span<const Field> now_of_world(std::span<const Field> fields);

 private:
  /// Translated words of the entity being made, or of one of its parts.
  struct TranslatedEntity {
    const Kind* kind = nullptr;
    std::vector<Field> words;
  };
  struct Rewriting {
    const ExpandedSection& entity;
    const FieldSet fields;
    const Kind& kind;
    const OldType* type;
    TranslatedEntity own;
    /// By type; none if the entity has such parts in current words.
    std::map<std::string_view, std::optional<std::vector<TranslatedEntity>>> parts;
  };

  const OldType* old_type_of(const ExpandedSection& entity);
  bool has_old_words(std::span<const Field> fields, const Kind& kind) const;
  Section rewritten(const ExpandedSection& entity, const Kind& kind, const OldType* type);
  /// False: the field is left as it is.
  bool apply(const Field& field, Rewriting& to);
  /// Warns of parts that `count` announces but that have no pose.
  void check_places(const Field& count, const Rewriting& of);
  bool apply_to_parts(const Field& field, const Meaning& meaning, Rewriting& to);
  void apply_words(const Field& field, const Meaning& meaning, TranslatedEntity& to);
  /// Hard-coded translations.
  std::optional<Field> by_hand(const Field& field, const Rewriting& to);
  std::optional<std::vector<TranslatedEntity>>& parts_of(std::string_view part, Rewriting& to);
  std::size_t count_parts(std::string_view part, const Rewriting& of);
  bool has_parts(const ExpandedSection& entity, std::string_view part) const;

  /// The word of that name, added if missing.
  Field& word_of(TranslatedEntity& entity, std::string_view name, SourceLine where);
  void say(TranslatedEntity& entity, std::span<const SaidWord> words, SourceLine where);
  void note(const Field& field, const Kind& kind, const Word& word, std::string_view instead);

  Value value(std::string_view text) const;
  Value number(double number);
  /// Parses values of a definition, "[0 8]", into the units of the file.
  std::vector<Value> values(const Kind& kind, std::string_view word, std::string_view text);

  LoadState& state_;
  const Macros& macros_;
  std::set<std::string_view> old_names_;                      // all translated words
  std::map<std::vector<const Section*>, Section> rewritten_;  // cache, keyed by the bodies of an entity
  std::deque<std::string> texts_;                             // storage of generated values
  Section world_;
  std::size_t parts_ = 0;  // created so far
};

}  // namespace playhouse::scene
