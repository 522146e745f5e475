#pragma once

/// Expansion of shared descriptions, for tests: afterwards rows of descriptions are rows of the world.

#include <vector>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// The same world with one description per model, and without a list of trees.
inline SceneDesc expanded(SceneDesc scene) {
  std::vector<ModelDesc> models;
  for (std::uint32_t row = 0; row < scene.trees.size(); ++row) {
    const TreeDesc& tree = scene.trees[row];
    const auto moved = static_cast<std::int32_t>(models.size()) - static_cast<std::int32_t>(tree.top);
    const std::string top = scene.models[tree.top].name;
    for (std::uint32_t at = 0; at < tree_size(scene, tree.top); ++at) {
      ModelDesc& model = models.emplace_back(scene.models[tree.top + at]);
      const auto renamed = scene.renamed.find({row, at});
      model.name =
          renamed == scene.renamed.end() ? token_in(model.name, top, tree.name) : renamed->second.name;
      model.alias =
          renamed == scene.renamed.end() ? token_in(model.alias, top, tree.name) : renamed->second.alias;
      if (at > 0) {
        model.parent += moved;
        continue;
      }
      model.name = tree.name;
      model.alias = tree.alias;
      model.where = tree.where;
      model.X_PM = tree.X_WM;
      model.color = tree.color;
      model.fiducial_return = tree.fiducial_return;
    }
  }
  scene.models = std::move(models);
  scene.trees.clear();
  scene.renamed.clear();
  return scene;
}

}  // namespace playhouse::scene
