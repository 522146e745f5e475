#pragma once

/// Equality of scenes apart from file positions, for tests and fuzzers.

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "playhouse/scene/testing_expanded.h"

namespace playhouse::scene {

inline std::string same_file(const std::string& path) {
  return path.empty() ? path : std::filesystem::absolute(path).lexically_normal().string();
}

/// True if a model lost its name to another one: its default name is not reproducible then.
inline bool has_lost_names(const SceneDesc& scene) {
  return std::ranges::any_of(scene.warnings, [](const std::string& warning) {
    return warning.find("this model has it now") != std::string::npos;
  });
}

/// The first difference between two models, or "".
inline std::string difference(const ModelDesc& a, const ModelDesc& b) {
  BodyDesc body = b.body;
  if (same_file(a.body.bitmap) == same_file(body.bitmap)) body.bitmap = a.body.bitmap;
  if (same_file(a.body.mesh) == same_file(body.mesh)) body.mesh = a.body.mesh;
  if (same_file(a.body.look) == same_file(body.look)) body.look = a.body.look;
  if (a.name != b.name) return "name, " + b.name;
  if (a.alias != b.alias) return "default name, " + b.alias;
  if (a.type != b.type || a.kind != b.kind) return "type";
  if (a.parent != b.parent) return "parent";
  if (static_cast<const PlainDesc&>(a) != static_cast<const PlainDesc&>(b)) return "words of every model";
  if (static_cast<const KindDescs&>(a) != static_cast<const KindDescs&>(b)) return "words of its kind";
  if (a.stacked != b.stacked || a.stacks_children != b.stacks_children) return "what it stands on";
  if (a.blocks != b.blocks || a.moving_blocks != b.moving_blocks || a.bitmaps != b.bitmaps ||
      a.body != body || (a.mesh == nullptr) != (b.mesh == nullptr) ||
      (a.look == nullptr) != (b.look == nullptr))
    return "body";
  if (a.kept != b.kept) return "words that are kept";
  return {};
}

/// The first difference, with the model's name, or "". Sharing of
/// descriptions may differ. Unnamed worlds are named after their files.
inline std::string difference(const SceneDesc& first, const SceneDesc& second) {
  SceneDesc a = expanded(first), b = expanded(second);
  if (has_lost_names(first))
    for (SceneDesc* scene : {&a, &b})
      for (ModelDesc& model : scene->models) model.alias.clear();
  WorldDesc world = b;
  if (a.name == a.path && b.name == b.path) world.name = a.name;
  if (static_cast<const WorldDesc&>(a) != world) return "words of the world";
  if (a.window != b.window) return "window";
  if (a.units.length != b.units.length || a.units.angle != b.units.angle) return "units";
  if (a.kept != b.kept || a.kept_of_window != b.kept_of_window) return "words that are kept";
  if (a.models.size() != b.models.size()) return "number of models: " + std::to_string(b.models.size());
  for (std::size_t row = 0; row < a.models.size(); ++row)
    if (const std::string what = difference(a.models[row], b.models[row]); !what.empty())
      return a.models[row].name + ": " + what;
  return {};
}

}  // namespace playhouse::scene
