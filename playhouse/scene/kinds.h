#pragma once

/// The vocabulary of world files as tables, generated from kinds/*.toml. Descriptions of
/// models are in generated/kind_descs.h; EntityForm, Index and Need in generated/kind_forms.h.

#include <cstdint>
#include <span>
#include <string_view>

#include "playhouse/scene/generated/kind_descs.h"
#include "playhouse/scene/generated/kind_forms.h"

namespace playhouse::scene {

/// Support of a word in this build.
enum class Support : std::uint8_t {
  kRead,    // read by this build
  kSilent,  // known to Stage 4; no effect on the simulation, or of a type that is not simulated
  kLater,   // known to Stage 4, not yet supported
  kOld,     // ignored by Stage 4 too; from older versions
};

/// A word and its value in file syntax: "range", "0 8".
struct SaidWord {
  std::string_view word, value;
};

/// Translation of an old word to current words.
struct Meaning {
  enum class How : std::uint8_t {
    kWords,   // sets the words `to`
    kCount,   // sets the number of parts
    kNested,  // word[1].points is `points` of the second part
  };
  How how = How::kWords;
  /// Type of the part that has the words; "": the entity itself. word[1]
  /// then refers to the second part, and word without an index to all.
  std::string_view part = {};
  /// The target word of each value, with its element, "range.1"; ""
  /// drops the value. A single word without an element takes all values.
  std::span<const std::string_view> to = {};
  std::span<const SaidWord> values = {};      // values to be replaced
  std::span<const SaidWord> part_words = {};  // defaults of each part, unless in the file
};

/// A word of an entity. Texts are for documentation, empty if not applicable.
struct Word {
  std::string_view name;
  Support use = Support::kRead;
  std::string_view type = {};        // flag, number, length, pose, choice, ...; "" for silent and old words
  std::string_view form = {};        // [x y z heading], or the options of a choice
  std::string_view unit = {};        // of file values: "m", "m, m, m, deg"
  std::string_view otherwise = {};   // default value, in file syntax
  std::string_view told = {};        // the default in words, if it is no value
  std::string_view limits = {};      // "above 0"
  std::string_view counted_by = {};  // the word with the length of word[0], word[1], ...
  std::string_view doc = {};
  std::string_view instead = {};     // of old words: the replacement
  const Meaning* meaning = nullptr;  // of old words that are translated
};

/// A Player interface that exposes models of a kind; those of "model" apply to every kind.
struct KindInterface {
  std::string_view name;
  std::uint16_t code = 0;
  Index index = Index::kCount;
  Need when = Need::kNothing;    // precondition for such a device
  Need listed = Need::kNothing;  // precondition for one in the automatic map
  bool shared = false;           // several devices of a configuration file may share one model
};

/// A kind of entity in world files. `solid`, `size` and `color` are defaults of models.
struct Kind {
  std::string_view name;  // as in files: "position", "sensor"
  std::string_view doc;
  EntityForm entity = EntityForm::kModel;
  std::string_view inside = {};
  std::string_view table = {};  // its table in the world's state, if any
  ModelKind kind = ModelKind::kPlain;
  bool simulated = false;  // false: loaded as a plain body with a warning
  bool solid = false;      // a body that fills its size, unless it has blocks or a bitmap
  geom::Size size = {};    // m
  Color color = {};
  std::span<const Word> words = {};  // own words; models also have those of "model"
  std::span<const KindInterface> interfaces = {};
  bool (*has)(const PlainDesc& model) = nullptr;  // of a trait: true if the model has it
};

/// A type of Stage 1 to 3, and its replacement.
struct OldType {
  std::string_view name, instead;
  bool is_read = false;
  std::string_view type = {};                 // type it is translated to; "": dropped
  std::string_view part = {};                 // part type that the translation needs at least once
  std::span<const SaidWord> words = {};       // defaults, unless in the file
  std::span<const SaidWord> part_words = {};  // defaults of those parts
};

/// All kinds: simulated model types in numeric order, other
/// model types, parts, traits, the window, the world.
std::span<const Kind> kinds();
std::span<const OldType> old_types();

/// The kind of that name, or null.
const Kind* find_kind(std::string_view name);
/// The same, restricted to entities that can be
/// sections of a file: not the world, not traits.
const Kind* find_entity(std::string_view name);
/// The same, restricted to model types.
const Kind* find_model_type(std::string_view name);
inline bool is_model_type(std::string_view name) {
  return find_model_type(name) != nullptr;
}
/// The kind of the file itself.
const Kind& world_kind();

/// A default model of that kind, as a root or as a part.
PlainDesc unsaid(const Kind& kind, bool at_top);

/// True if `part` may be nested in models of that kind.
bool is_part_of(const Kind& part, const Kind& model);

/// Words of a kind beyond its own.
std::span<const Word> common_words(const Kind& kind);
/// Looks up a word, own or common; null if there is none.
const Word* find_word(const Kind& kind, std::string_view name);

}  // namespace playhouse::scene
