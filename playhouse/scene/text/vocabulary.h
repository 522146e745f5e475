#pragma once

/// Warnings about words without effect and
/// unknown types. The vocabulary is in kinds.h.

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/kinds.h"
#include "playhouse/scene/properties.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// Suggestion for an unknown type: ` (did you mean "ranger"?)`, or the Stage 4 replacement
/// of an older type; "" if nothing is similar. `others` are further valid names.
std::string what_instead(std::string_view name, std::span<const std::string_view> others);

/// Display name of a kind: "ranger", "the world".
std::string owner_of(const Kind& kind);

/// The parent of a part type: "a ranger".
std::string place_of(const Kind& kind);

/// Words of an entity that Stage 4 supports and this build does not.
std::vector<KeptWord> kept_words(const Kind& kind, const Properties& properties);

/// Warns of properties without effect: once per line for unknown words, once per load
/// for words of older Stage versions or of features that this build does not simulate.
class VocabularyCheck {
 public:
  void check(const Kind& kind, const Properties& properties);

 private:
  std::set<const config::Field*> checked_;
  std::set<std::string_view> words_;  // unsupported words already reported
};

}  // namespace playhouse::scene
