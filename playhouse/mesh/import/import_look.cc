#include "playhouse/mesh/import/import_look.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/mesh_limits.h"
#include "playhouse/mesh/color.h"
#include "playhouse/mesh/image_file.h"
#include "playhouse/mesh/import/beside.h"

namespace playhouse::mesh {
namespace {

constexpr float kRough = 0.8f;  // default roughness
constexpr float kPlain = 0.6f;  // default reflectance

std::optional<float> number(const aiMaterial& from, const char* key, unsigned type, unsigned index) {
  ai_real value = 0;
  if (from.Get(key, type, index, value) != aiReturn_SUCCESS || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<aiColor4D> color(const aiMaterial& from, const char* key, unsigned type, unsigned index) {
  aiColor4D value;
  if (from.Get(key, type, index, value) != aiReturn_SUCCESS) return std::nullopt;
  return value;
}

std::optional<std::string> texture(const aiMaterial& from,
                                   std::initializer_list<aiTextureType> types = {aiTextureType_BASE_COLOR,
                                                                                 aiTextureType_DIFFUSE}) {
  for (const aiTextureType type : types) {
    aiString name;
    if (from.GetTextureCount(type) > 0 && from.GetTexture(type, 0, &name) == aiReturn_SUCCESS &&
        name.length > 0)
      return std::string(name.C_Str());
  }
  return std::nullopt;
}

/// Roughness of a Phong exponent, with a similar lobe.
/// Source: Karis, "Specular BRDF reference", 2013: roughness^4 = 2 / (n + 2).
float roughness_of(float exponent) {
  return std::sqrt(std::sqrt(2 / (std::max(exponent, 0.0f) + 2)));
}

/// Takes its pixels from the budget.
Result<Image> decoded(std::string_view bytes, PixelBudget& pixels) {
  Result<Image> image = decode_image(bytes, pixels.most(bytes.size()));
  if (image) pixels.use(image->rgba.size() / 4);
  return image;
}

/// Pixels of an embedded texture.
Result<Image> image_of(const aiTexture& from, PixelBudget& pixels) {
  if (from.mHeight == 0) return decoded({reinterpret_cast<const char*>(from.pcData), from.mWidth}, pixels);
  Image image{from.mWidth, from.mHeight, {}};
  const std::size_t count = std::size_t{image.width} * image.height;
  const std::size_t most_pixels = pixels.most(count);
  if (image.width > limits::kMeshImageSide || image.height > limits::kMeshImageSide || count > most_pixels)
    return Error{{}, "has too many pixels"};
  pixels.use(count);
  for (std::size_t i = 0; i < count; ++i) {
    const aiTexel& pixel = from.pcData[i];
    image.rgba.insert(image.rgba.end(), {pixel.r, pixel.g, pixel.b, pixel.a});
  }
  return image;
}

Result<Image> image_beside(const std::string& name, const std::string& folder, const ReadFile& read,
                           PixelBudget& pixels) {
  Error why{{}, "is not beside the mesh"};
  std::vector<std::string> places = places_beside(name);
  // Of a model of Gazebo, beside the folder of its meshes.
  if (!places.empty())
    places.push_back("../materials/textures/" + places.back().substr(places.back().rfind('/') + 1));
  for (const std::string& place : places) {
    const Result<std::string> bytes = read(folder + place);
    if (bytes) return decoded(*bytes, pixels);
    if (place == places.front()) why = bytes.error();
  }
  return why;
}

/// Mean light of the pixels, linear.
std::array<float, 3> mean_of(const Image& image) {
  std::array<double, 256> linear;
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = linear_of_srgb(static_cast<double>(i) / 255);
  std::array<double, 3> sum = {};
  const std::size_t pixels = image.rgba.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += linear[image.rgba[4 * i + c]];
  std::array<float, 3> mean = {};
  for (std::size_t c = 0; c < 3 && pixels > 0; ++c)
    mean[c] = static_cast<float>(sum[c] / static_cast<double>(pixels));
  return mean;
}

}  // namespace

float LookImport::light(float channel) const {
  if (colors_ == Colors::kGltf) return channel;
  return static_cast<float>(linear_of_srgb(channel));
}

/// glTF: by alphaMode; other formats: blending if the
/// material is not opaque, otherwise alpha test for textures.
void LookImport::set_opacity(const aiMaterial& from, Material& to) const {
  if (colors_ != Colors::kGltf) to.base[3] = number(from, AI_MATKEY_OPACITY).value_or(1);
  to.base[3] = std::clamp(to.base[3], 0.0f, 1.0f);
  // Nobody models what cannot be seen: old exporters of Blender write a transparency of 0 for opaque
  // materials.
  if (colors_ == Colors::kCollada && to.base[3] == 0) to.base[3] = 1;
  if (colors_ != Colors::kGltf) {
    to.opacity = to.base[3] < 1 ? Opacity::kClear : Opacity::kHoles;
    return;
  }
  aiString mode;
  from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode);
  const std::string_view says(mode.C_Str());
  to.opacity = says == "BLEND" ? Opacity::kClear : says == "MASK" ? Opacity::kHoles : Opacity::kSolid;
  if (to.opacity == Opacity::kSolid) to.base[3] = 1;
  to.least_opacity = number(from, AI_MATKEY_GLTF_ALPHACUTOFF).value_or(to.least_opacity);
}

/// Assimp's default color, 0.6 in sRGB, is reported if the file has none.
bool LookImport::has_color(const aiMaterial& from, const std::string& name) const {
  if (colors_ == Colors::kObj) return colored_.contains(name);
  return colors_ == Colors::kGltf || name != AI_DEFAULT_MATERIAL_NAME || texture(from);
}

std::array<float, 4> LookImport::base_of(const aiMaterial& from, const std::string& name) const {
  int shading = 0;
  from.Get(AI_MATKEY_SHADING_MODEL, shading);
  // COLLADA's <constant> has emission only; a <diffuse> is a color or a texture.
  if (colors_ == Colors::kCollada && shading == aiShadingMode_NoShading) return {0, 0, 0, 1};
  if (colors_ == Colors::kCollada && texture(from)) return {1, 1, 1, 1};
  if (!has_color(from, name)) {
    const float plain = texture(from) ? 1 : kPlain;
    return {plain, plain, plain, 1};
  }
  std::optional<aiColor4D> base = color(from, AI_MATKEY_BASE_COLOR);
  if (!base || colors_ != Colors::kGltf) base = color(from, AI_MATKEY_COLOR_DIFFUSE);
  if (!base) return {1, 1, 1, 1};
  return {light(base->r), light(base->g), light(base->b), base->a};
}

Material LookImport::material(const aiMaterial& from) const {
  Material to;
  aiString name;
  if (from.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) to.name = name.C_Str();
  to.base = base_of(from, to.name);
  set_opacity(from, to);
  if (const auto glow = color(from, AI_MATKEY_COLOR_EMISSIVE))
    to.emission = {light(glow->r), light(glow->g), light(glow->b)};
  if (colors_ == Colors::kGltf) {
    to.metallic = std::clamp(number(from, AI_MATKEY_METALLIC_FACTOR).value_or(1), 0.0f, 1.0f);
    to.roughness = std::clamp(number(from, AI_MATKEY_ROUGHNESS_FACTOR).value_or(1), 0.0f, 1.0f);
  } else {
    const auto exponent = number(from, AI_MATKEY_SHININESS);
    to.roughness = exponent && *exponent > 0 ? roughness_of(*exponent) : kRough;
  }
  int is_two_sided = 0;
  from.Get(AI_MATKEY_TWOSIDED, is_two_sided);
  // Other formats rarely state it, and walls without thickness are common.
  to.is_two_sided = colors_ != Colors::kGltf || is_two_sided != 0;
  return to;
}

void LookImport::add_materials(Mesh& mesh) const {
  for (unsigned i = 0; i < scene_.mNumMaterials; ++i)
    mesh.materials.push_back(material(*scene_.mMaterials[i]));
}

void LookImport::add_textures(MeshFile& file, const std::string& folder, const ReadFile& read) const {
  std::map<std::string, std::uint32_t> rows;
  PixelBudget pixels(bytes_);
  for (unsigned i = 0; i < scene_.mNumMaterials; ++i) {
    const std::optional<std::string> name = texture(*scene_.mMaterials[i]);
    if (!name) continue;
    const auto [entry, is_new] = rows.try_emplace(*name, Material::kNone);
    std::uint32_t& row = entry->second;
    if (is_new && file.mesh.images.size() < limits::kMeshImages) {
      Result<Image> image = load(*name, folder, read, pixels);
      if (image) {
        row = static_cast<std::uint32_t>(file.mesh.images.size());
        file.mesh.images.push_back(std::move(*image));
      } else {
        file.warnings.push_back("texture " + in_quotes(*name) + " " + image.error().text +
                                "; surfaces have their color alone");
      }
    }
    file.mesh.materials[i].texture = row;
  }
}

Result<Image> LookImport::load(const std::string& name, const std::string& folder, const ReadFile& read,
                               PixelBudget& pixels) const {
  const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str());
  return embedded ? image_of(*embedded, pixels) : image_beside(name, folder, read, pixels);
}

void LookImport::dim_emission(MeshFile& file, const std::string& folder, const ReadFile& read) const {
  std::map<std::string, std::array<float, 3>> means;
  PixelBudget pixels(bytes_);
  for (unsigned i = 0; i < scene_.mNumMaterials; ++i) {
    const std::optional<std::string> name = texture(*scene_.mMaterials[i], {aiTextureType_EMISSIVE});
    std::array<float, 3>& emission = file.mesh.materials[i].emission;
    if (!name || emission == std::array<float, 3>{}) continue;
    const auto [entry, is_new] = means.try_emplace(*name);
    if (is_new) {
      const Result<Image> image = load(*name, folder, read, pixels);
      if (image)
        entry->second = mean_of(*image);
      else
        file.warnings.push_back("texture " + in_quotes(*name) + " " + image.error().text +
                                "; surfaces do not glow");
    }
    for (std::size_t c = 0; c < 3; ++c) emission[c] *= entry->second[c];
  }
}

/// Intensity of a light in candela, as in glTF. A COLLADA light of color 1 is taken
/// as 1 W, as in Blender, which writes color times power, and exports the same light
/// to glTF so: an isotropic 683 lm per watt. Only the hue is decoded from sRGB.
Light3 LookImport::candela(const aiColor3D& color) const {
  constexpr float kCandela = 683 / (4 * static_cast<float>(geom::kPi));
  if (colors_ == Colors::kGltf) return {color.r, color.g, color.b};
  const float most = std::max({color.r, color.g, color.b});
  if (!(most > 0)) return {0, 0, 0};
  return {kCandela * most * light(color.r / most), kCandela * most * light(color.g / most),
          kCandela * most * light(color.b / most)};
}

void LookImport::add_lights(const Nodes& nodes, Mesh& mesh) const {
  for (unsigned i = 0; i < scene_.mNumLights && i < limits::kMeshLights; ++i) {
    const aiLight& from = *scene_.mLights[i];
    const auto node =
        std::ranges::find_if(nodes, [&](const SceneNode& one) { return one.node->mName == from.mName; });
    if (node == nodes.end()) continue;
    Light to;
    switch (from.mType) {
      case aiLightSource_POINT:
        to.kind = LightKind::kPoint;
        break;
      case aiLightSource_DIRECTIONAL:
        to.kind = LightKind::kDirection;
        break;
      case aiLightSource_SPOT:
        to.kind = LightKind::kSpot;
        break;
      default:
        continue;  // an ambient light has no position
    }
    const auto vec = [](const aiVector3D& v) { return geom::Vec3{v.x, v.y, v.z}; };
    to.p = node->X_FN * vec(from.mPosition);
    to.d = unit(node->X_FN.turn(vec(from.mDirection)), {0, 0, -1});
    to.color = candela(from.mColorDiffuse);
    // COLLADA has full angles, glTF half angles.
    const float share = colors_ == Colors::kGltf ? 1 : 0.5f;
    to.inner = share * from.mAngleInnerCone;
    to.outer = share * from.mAngleOuterCone;
    mesh.lights.push_back(to);
  }
}

}  // namespace playhouse::mesh
