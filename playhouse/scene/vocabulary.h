#pragma once

/// The words of Stage world files: model types and properties, and what this build makes of each.

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/properties.h"

namespace playhouse::scene {

/// A model type that Stage 4 knows, with its defaults.
struct ModelType {
  std::string_view name;
  ModelKind kind;
  bool simulated;  // false: loads as a plain body with one warning
  bool has_body;   // a box that fills its size, unless blocks or a bitmap say otherwise
  geom::Size size;
  Color color;
};

/// The type of that name, or null.
const ModelType* find_model_type(std::string_view name);

/// Why `name` is no model type and what to write instead: `unknown model type "lazer" (did you mean ...?)`.
/// `macros` are the names that would also have been possible.
std::string unknown_type(std::string_view name, std::span<const std::string_view> macros);

/// The entities that have properties.
enum class Vocabulary { kWorld, kWindow, kModel, kBlock, kSensor };

/// Warns of properties that do nothing: once per line for words that are unknown, once per load for words
/// that older or other versions of Stage know, or that stand for something this build does not simulate.
class VocabularyCheck {
 public:
  /// `type` is the model type for kModel, else "".
  void check(Vocabulary vocabulary, std::string_view type, const Properties& properties);

 private:
  std::set<const Field*> checked_;
  std::set<std::string_view> words_;
};

}  // namespace playhouse::scene
