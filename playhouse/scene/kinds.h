#pragma once

/// What a world file can hold, as kinds/*.toml defines it, in tables. What one model says about itself is in
/// generated/kind_descs.h, and EntityForm, Index and Need in generated/kind_forms.h.

#include <cstdint>
#include <span>
#include <string_view>

#include "playhouse/scene/generated/kind_descs.h"
#include "playhouse/scene/generated/kind_forms.h"

namespace playhouse::scene {

/// What this build makes of a word.
enum class Use : std::uint8_t {
  kRead,    // read by this build
  kSilent,  // known to Stage 4, of no consequence for the simulation, or of a type that is not simulated
  kLater,   // known to Stage 4, not simulated by this build
  kOld,     // ignored by Stage 4 too; older versions knew it
};

/// A word and its value as a file has them: "range", "0 8".
struct SaidWord {
  std::string_view word, value;
};

/// What an old word means now, by today's words.
struct Meaning {
  enum class How : std::uint8_t {
    kWords,   // says `to`
    kCount,   // how many parts there are
    kNested,  // word[1].points is `points` of the second part
  };
  How how = How::kWords;
  /// Whose words they are: those of the entity itself, if "". word[1] is then of the second part, and word
  /// alone of all.
  std::string_view part = {};
  /// The word of each value, with the element that it is, "range.1", or "" of one that means nothing. One
  /// word without an element has all values.
  std::span<const std::string_view> to = {};
  std::span<const SaidWord> values = {};      // that have others now
  std::span<const SaidWord> part_words = {};  // of each part, where the file does not say them
};

/// A word that an entity can have. Texts are as people read them, empty where there is nothing to say.
struct Word {
  std::string_view name;
  Use use = Use::kRead;
  std::string_view type = {};        // flag, number, length, pose, choice, ...; "" of silent and old words
  std::string_view form = {};        // [x y z heading], or the words of a choice
  std::string_view unit = {};        // by default: "m", "m, m, m, deg"
  std::string_view otherwise = {};   // what counts without the word, as a file would say it
  std::string_view told = {};        // the same in words, where it is no value
  std::string_view limits = {};      // "above 0"
  std::string_view counted_by = {};  // the word that says how many there are, word[0], word[1], ...
  std::string_view doc = {};
  std::string_view instead = {};     // of old words: what to write
  const Meaning* meaning = nullptr;  // of old words that are read
};

/// An interface of Player through which models of a kind are seen; those of "model" are of every kind.
struct KindInterface {
  std::string_view name;
  std::uint16_t code = 0;
  Index index = Index::kCount;
  Need when = Need::kNothing;    // that there can be such a device
  Need listed = Need::kNothing;  // that the automatic map has one
  bool shared = false;           // several devices of a configuration file may be of one model
};

/// What a world file can hold. `solid`, `size` and `color` are those of models.
struct Kind {
  std::string_view name;  // as files have it: "position", "sensor"
  std::string_view doc;
  EntityForm entity = EntityForm::kModel;
  std::string_view inside = {};
  std::string_view table = {};  // of the world's state, where it has one
  ModelKind kind = ModelKind::kPlain;
  bool simulated = false;  // false: a model of this type loads as a plain body with one warning
  bool solid = false;      // a body that fills its size, unless blocks or a bitmap say otherwise
  geom::Size size = {};    // m
  Color color = {};
  std::span<const Word> words = {};  // its own; every model has those of "model" besides
  std::span<const KindInterface> interfaces = {};
  bool (*has)(const PlainDesc& model) = nullptr;  // of a trait: whether the model has it
};

/// A type of Stage 1 to 3, and what to write in its place.
struct OldType {
  std::string_view name, instead;
  bool is_read = false;
  std::string_view type = {};                 // what it is read as; "" nothing
  std::string_view part = {};                 // of which that has one at least
  std::span<const SaidWord> words = {};       // that it says, where the file does not
  std::span<const SaidWord> part_words = {};  // the same of these parts
};

/// Model types that are simulated in the order of their numbers, other model types, parts, traits, the
/// window, the world.
std::span<const Kind> kinds();
std::span<const OldType> old_types();

/// The kind of that name, or null.
const Kind* find_kind(std::string_view name);
/// The same of what a file writes with brackets: no file has an entity that is the world or a
/// trait.
const Kind* find_entity(std::string_view name);
/// The same of models alone.
const Kind* find_model_type(std::string_view name);
/// The kind of the file itself.
const Kind& world_kind();

/// A model of that kind that says nothing, at the top level or inside another.
PlainDesc unsaid(const Kind& kind, bool at_top);

/// Whether `part` belongs into models of that kind.
bool is_part_of(const Kind& part, const Kind& model);

/// Words that a kind has besides its own.
std::span<const Word> common_words(const Kind& kind);
/// The word of that name, among its own or the common ones, or null.
const Word* find_word(const Kind& kind, std::string_view name);

}  // namespace playhouse::scene
