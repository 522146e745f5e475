#pragma once

/// Imports materials, textures and lights from an Assimp scene.

#include <assimp/scene.h>

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "playhouse/mesh/cost.h"
#include "playhouse/mesh/import/import_surfaces.h"
#include "playhouse/mesh/read_mesh.h"

namespace playhouse::mesh {

/// Colour space of a format: glTF is linear; COLLADA
/// and OBJ are sRGB, OBJ with a factor on textures. STL
/// has no colours, like an OBJ file without materials.
enum class Colors : std::uint8_t { kGltf, kCollada, kObj };

class LookImport {
 public:
  /// `colored`: for OBJ, the materials that define a color. `bytes`: of the mesh file, for its textures.
  LookImport(const aiScene& scene, Colors colors, std::set<std::string> colored, std::size_t bytes)
      : scene_(scene), colors_(colors), colored_(std::move(colored)), bytes_(bytes) {}

  /// In the order of the scene, without textures.
  void add_materials(Mesh& mesh) const;
  /// Textures of materials, embedded or in files below `folder`.
  void add_textures(MeshFile& file, const std::string& folder, const ReadFile& read) const;
  /// Materials have one emission each: that of an emissive texture is its mean.
  void dim_emission(MeshFile& file, const std::string& folder, const ReadFile& read) const;
  void add_lights(const Nodes& nodes, Mesh& mesh) const;

 private:
  Result<Image> load(const std::string& name, const std::string& folder, const ReadFile& read,
                     PixelBudget& pixels) const;
  Material material(const aiMaterial& from) const;
  void set_opacity(const aiMaterial& from, Material& to) const;
  std::array<float, 4> base_of(const aiMaterial& from, const std::string& name) const;
  /// True if the color that Assimp reports is from the file, not a default.
  bool has_color(const aiMaterial& from, const std::string& name) const;
  float light(float channel) const;
  Light3 candela(const aiColor3D& color) const;

  const aiScene& scene_;
  Colors colors_;
  std::set<std::string> colored_;
  std::size_t bytes_;
};

}  // namespace playhouse::mesh
