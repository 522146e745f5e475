#pragma once

/// Materials, textures and lights of an Assimp scene.

#include <assimp/scene.h>

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "playhouse/mesh/import_surfaces.h"
#include "playhouse/mesh/read_mesh.h"

namespace playhouse::mesh {

/// How a format says colors: glTF as light; COLLADA and OBJ as screens show them, OBJ with a factor beside a
/// texture.
enum class Colors : std::uint8_t { kGltf, kCollada, kObj };

class Look {
 public:
  /// `colored`: of OBJ, the materials that have a color.
  Look(const aiScene& scene, Colors colors, std::set<std::string> colored)
      : scene_(scene), colors_(colors), colored_(std::move(colored)) {}

  /// In the order of the scene, without textures.
  void add_materials(Mesh& mesh) const;
  /// The textures of materials, embedded ones and those in files of `folder`.
  void add_textures(MeshFile& file, const std::string& folder, const ReadFile& read) const;
  void add_lights(const Nodes& nodes, Mesh& mesh) const;

 private:
  Material material(const aiMaterial& from) const;
  void set_opacity(const aiMaterial& from, Material& to) const;
  std::array<float, 4> base_of(const aiMaterial& from, const std::string& name) const;
  /// Whether the file says the color that Assimp tells.
  bool has_color(const aiMaterial& from, const std::string& name) const;
  float light(float channel) const;
  Light3 candela(const aiColor3D& color) const;

  const aiScene& scene_;
  Colors colors_;
  std::set<std::string> colored_;
};

}  // namespace playhouse::mesh
