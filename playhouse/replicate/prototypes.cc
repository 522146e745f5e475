#include "playhouse/replicate/prototypes.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>

#include "playhouse/mesh/mesh.h"
#include "playhouse/replicate/json_text.h"
#include "playhouse/replicate/views.h"
#include "playhouse/scene/forms/materials.h"

namespace playhouse::replicate {
namespace {

/// Interned texts, in order of first use.
class Texts {
 public:
  std::uint32_t row(std::string text) {
    const auto [it, fresh] = rows_.try_emplace(std::move(text), static_cast<std::uint32_t>(rows_.size()));
    if (fresh) {
      if (!all_.empty()) all_ += ",\n";
      all_ += it->first;
    }
    return it->second;
  }
  std::string take() { return std::move(all_); }

 private:
  std::map<std::string, std::uint32_t> rows_;
  std::string all_;
};

/// "wander" of "wander 3 fast".
std::string_view first_word(std::string_view line) {
  return line.substr(0, line.find(' '));
}

std::string polygon(const std::vector<geom::Vec2>& points) {
  return list(points, [](geom::Vec2 p) { return number(p.x) + ',' + number(p.y); });
}

/// {"z": [min, max], "loops": [[x, y, ...], ...]} of each solid: a block has one loop.
std::string shape(const scene::ModelDesc& model) {
  const auto solid = [](double z_min, double z_max, const std::string& loops) {
    return fmt::format(R"({{"z":[{},{}],"loops":{}}})", number(z_min), number(z_max), loops);
  };
  std::string text = list(model.blocks, [&](const scene::Block& block) {
    return solid(block.z_min, block.z_max, fmt::format("[{}]", polygon(block.points)));
  });
  const std::string traced = list(model.bitmaps, [&](const scene::Contours& bitmap) {
    return solid(bitmap.z_min, bitmap.z_max, list(bitmap.loops, polygon));
  });
  if (text == "[]") return traced;
  if (traced == "[]") return text;
  text.back() = ',';
  return text + traced.substr(1);
}

using Meshes = std::vector<std::shared_ptr<const mesh::Mesh>>;

/// Index of a mesh, in order of first use.
std::size_t row_of(const std::shared_ptr<const mesh::Mesh>& mesh, Meshes& meshes) {
  const auto found = std::ranges::find(meshes, mesh);
  if (found != meshes.end()) return static_cast<std::size_t>(found - meshes.begin());
  meshes.push_back(mesh);
  return meshes.size() - 1;
}

/// A point or spot light of a mesh.
std::string light(const mesh::Light& light) {
  std::string text = fmt::format(R"({{"p":{},"candela":{})", triple(light.p.x, light.p.y, light.p.z),
                                 triple(light.color[0], light.color[1], light.color[2]));
  if (light.kind == mesh::LightKind::kSpot)
    text += fmt::format(R"(,"way":{},"inner":{},"outer":{})", triple(light.d.x, light.d.y, light.d.z),
                        number(light.inner), number(light.outer));
  return text + "}";
}

std::string lights(const mesh::Mesh& mesh) {
  std::vector<mesh::Light> placed = mesh.lights;
  std::erase_if(placed, [](const mesh::Light& light) { return light.kind == mesh::LightKind::kDirection; });
  return placed.empty() ? std::string() : fmt::format(R"(,"lights":{})", list(placed, light));
}

std::string prototype(const scene::ModelDesc& model, Texts& shapes, Meshes& meshes) {
  std::string text = fmt::format(R"({{"type":{},"kind":"{}")", quoted(model.type), kind_name(model.kind));
  auto out = std::back_inserter(text);
  if (!model.ctrl.empty())
    fmt::format_to(out, R"(,"controllers":{})",
                   list(model.ctrl, [](const std::string& line) { return quoted(first_word(line)); }));
  if (model.X_MB != geom::Pose{}) fmt::format_to(out, R"(,"origin":{})", pose(model.X_MB));
  fmt::format_to(out, R"(,"size":{})", size(model.size));
  if (!model.blocks.empty() || !model.bitmaps.empty())
    fmt::format_to(out, R"(,"shape":{})", shapes.row(shape(model)));
  if (const auto& drawn = model.look ? model.look : model.mesh)
    fmt::format_to(out, R"(,"mesh":"{}")", mesh_address(row_of(drawn, meshes)));
  if (model.look) text += R"(,"painted":true)";
  if (model.mesh) text += lights(*model.mesh);
  if (model.lamp > 0) fmt::format_to(out, R"(,"lamp":{})", number(model.lamp));
  if (const scene::NamedMaterial material = scene::material_of(model);
      !material.name.empty() || model.roughness)
    fmt::format_to(out, R"(,"shine":[{},{}])", number(material.metallic), number(material.roughness));
  if (scene::is_smoke(model)) text += R"(,"smoke":true)";
  if (model.moving_blocks > 0) fmt::format_to(out, R"(,"moving":{})", model.moving_blocks);
  if (model.gui_move) text += R"(,"movable":true)";
  if (model.gui_nose) text += R"(,"nose":true)";
  if (model.gui_outline) text += R"(,"outline":true)";
  if (model.gui_grid) text += R"(,"grid":true)";
  tell_kind(model, text);
  return text += '}';
}

/// Names of spawnable prototypes: the macro's name, or for further ones of the same macro the first
/// model's. In scenes made in code, which share no descriptions, trees that look alike are merged.
std::vector<Addable> addable_of(const scene::SceneDesc& scene, std::span<const std::uint32_t> of_desc) {
  std::vector<Addable> addable;
  std::set<std::string> names;
  std::set<std::vector<std::uint32_t>> looks;
  for (std::uint32_t row = 0; row < scene.models.size(); ++row) {
    const scene::ModelDesc& model = scene.models[row];
    if (model.parent >= 0 || !model.gui_move) continue;
    const auto tree = of_desc.subspan(row, scene::tree_size(scene, row));
    if (model.prototype.empty() && !looks.emplace(tree.begin(), tree.end()).second) continue;
    const bool is_new = !model.prototype.empty() && names.insert(model.prototype).second;
    addable.push_back({is_new ? model.prototype : model.name, row});
  }
  return addable;
}

}  // namespace

std::string mesh_address(std::size_t row) {
  return fmt::format("meshes/{}.glb", row);
}

Prototypes::Prototypes(const scene::SceneDesc& scene) {
  Texts shapes, texts;
  of_desc_.reserve(scene.models.size());
  for (const scene::ModelDesc& model : scene.models)
    of_desc_.push_back(texts.row(prototype(model, shapes, meshes_)));
  addable_ = addable_of(scene, of_desc_);
  shapes_ = shapes.take();
  texts_ = texts.take();
}

}  // namespace playhouse::replicate
