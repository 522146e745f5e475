#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

std::uint32_t tree_size(const SceneDesc& scene, std::uint32_t row) {
  if (row >= scene.models.size() || scene.models[row].parent >= 0) return 0;
  std::uint32_t end = row + 1;
  while (end < scene.models.size() && scene.models[end].parent >= static_cast<std::int32_t>(row)) ++end;
  return end - row;
}

std::vector<TreeDesc> one_of_each(const SceneDesc& scene) {
  std::vector<TreeDesc> trees;
  for (std::uint32_t row = 0; row < scene.models.size(); ++row) {
    const ModelDesc& top = scene.models[row];
    if (top.parent >= 0) continue;
    trees.push_back({row, top.name, top.alias, top.where, top.X_PM, top.color, top.fiducial_return});
  }
  return trees;
}

std::string token_in(std::string_view token, std::string_view top, std::string_view name) {
  const bool follows = token.size() > top.size() && token.starts_with(top) && token[top.size()] == '.';
  return follows ? std::string(name).append(token.substr(top.size())) : std::string(token);
}

}  // namespace playhouse::scene
