#pragma once

/// Worlds of Stage 1 to 3 in today's words: each entity whose type or words are old becomes one that says the
/// same now, as `[old]` and `[old_types]` of kinds/*.toml have it, before anybody reads it. One warning for
/// each old word. Two things no table says: `interval_real` of the world, and a window's scale in metres per
/// pixel.

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

  /// The entity in today's words. Its type is "" where nothing is left of it.
  Instance now(Instance entity);
  /// The words of the world.
  std::span<const Field> now_of_world(std::span<const Field> fields);

 private:
  /// What is said by old words of an entity that is made, or of one of its parts.
  struct Entity {
    const Kind* kind = nullptr;
    std::vector<Field> words;
  };
  struct Rewriting {
    const Instance& entity;
    const FieldSet fields;
    const Kind& kind;
    const OldType* type;
    Entity own;
    /// By their type; none where the entity has such parts in today's words.
    std::map<std::string_view, std::optional<std::vector<Entity>>> parts;
  };

  const OldType* old_type_of(const Instance& entity);
  bool has_old_words(std::span<const Field> fields, const Kind& kind) const;
  Section rewritten(const Instance& entity, const Kind& kind, const OldType* type);
  /// False: the field is left as it is.
  bool apply(const Field& field, Rewriting& to);
  /// Warns of parts that `count` counts and that have no place.
  void check_places(const Field& count, const Rewriting& of);
  bool apply_to_parts(const Field& field, const Meaning& meaning, Rewriting& to);
  void apply_words(const Field& field, const Meaning& meaning, Entity& to);
  /// What a field is now that no table has.
  std::optional<Field> by_hand(const Field& field, const Rewriting& to);
  std::optional<std::vector<Entity>>& parts_of(std::string_view part, Rewriting& to);
  std::size_t count_parts(std::string_view part, const Rewriting& of);
  bool has_parts(const Instance& entity, std::string_view part) const;

  /// The word of that name, which is new if nothing was said of it yet.
  Field& word_of(Entity& entity, std::string_view name, SourceLine where);
  void say(Entity& entity, std::span<const SaidWord> words, SourceLine where);
  void note(const Field& field, const Kind& kind, const Word& word, std::string_view instead);

  Value value(std::string_view text) const;
  Value number(double number);
  /// The values of a word as a definition has them, "[0 8]", in the units of the file.
  std::vector<Value> values(const Kind& kind, std::string_view word, std::string_view text);

  LoadState& state_;
  const Macros& macros_;
  std::set<std::string_view> old_names_;                      // of words that are read
  std::map<std::vector<const Section*>, Section> rewritten_;  // entities, by what they are made of
  std::deque<std::string> texts_;                             // of values that no file has
  Section world_;
  std::size_t parts_ = 0;  // made so far
};

}  // namespace playhouse::scene
