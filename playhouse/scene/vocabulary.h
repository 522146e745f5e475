#pragma once

/// What is said of words that do nothing, and of types that nobody knows. Which words there are is in
/// kinds.h.

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/kinds.h"
#include "playhouse/scene/properties.h"

namespace playhouse::scene {

/// What to write instead of a name that is no entity: ` (did you mean "ranger"?)`, or what Stage 4 has
/// instead of an older type; "" when nothing is near. `others` are names that would also have been possible.
std::string what_instead(std::string_view name, std::span<const std::string_view> others);

/// "ranger", "the world".
std::string owner_of(const Kind& kind);

/// Where an entity belongs that is no model: "a ranger".
std::string place_of(const Kind& kind);

/// What an entity says that Stage 4 reads and this build does not.
std::vector<KeptWord> kept_words(const Kind& kind, const Properties& properties);

/// Warns of properties that do nothing: once per line for words that are unknown, once per load for words
/// that older versions of Stage know, or that stand for something this build does not simulate.
class VocabularyCheck {
 public:
  void check(const Kind& kind, const Properties& properties);

 private:
  std::set<const Field*> checked_;
  std::set<std::string_view> words_;  // that are not simulated
};

}  // namespace playhouse::scene
