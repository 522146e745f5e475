#include "playhouse/mesh/glb_writer.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

#include "playhouse/images/write_png.h"
#include "playhouse/mesh/opacity.h"

namespace playhouse::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

/// Constants of the specification.
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kFloat = 5126, kUnsignedInt = 5125, kVertices = 34962, kIndices = 34963, kNoTarget = 0;

void append(std::string& out, std::uint32_t number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  out.append(bytes, sizeof number);
}

/// Pads a chunk to a multiple of four bytes.
void append_chunk(std::string& out, std::uint32_t type, std::string chunk, char fill) {
  chunk.resize((chunk.size() + 3) / 4 * 4, fill);
  append(out, static_cast<std::uint32_t>(chunk.size()));
  append(out, type);
  out += chunk;
}

using Points = std::vector<std::array<float, 3>>;

Points turned(std::span<const std::array<float, 3>> from, const geom::Pose& X, bool is_direction) {
  const geom::Rotation turn = geom::Rotation::of(X.a);
  Points to;
  for (const auto& p : from) {
    const geom::Vec2 q = turn * geom::Vec2{p[0], p[1]};
    const double share = is_direction ? 0 : 1;
    to.push_back({static_cast<float>(q.x + share * X.x), static_cast<float>(q.y + share * X.y),
                  static_cast<float>(p[2] + share * X.z)});
  }
  return to;
}

/// Only where needed, since blending is expensive for viewers.
std::string alpha_mode(const Mesh& mesh, const Material& material) {
  if (is_see_through(mesh, material)) return R"(,"alphaMode":"BLEND")";
  if (is_all_hole(material) || (material.opacity == Opacity::kHoles && has_clear_texture(mesh, material)))
    return fmt::format(R"(,"alphaMode":"MASK","alphaCutoff":{})", material.least_opacity);
  return {};
}

}  // namespace

std::size_t GlbWriter::add_view(std::span<const std::byte> bytes, int target) {
  binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
  const std::size_t offset = binary_.size();
  binary_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return views_.add(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", offset, bytes.size(),
                    target == kNoTarget ? "" : fmt::format(R"(,"target":{})", target));
}

std::size_t GlbWriter::add_points(std::span<const std::array<float, 3>> points) {
  std::array<float, 3> low = points.front(), high = points.front();
  for (const auto& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  return accessors_.add(
      R"({{"bufferView":{},"componentType":{},"count":{},"type":"VEC3","min":[{},{},{}],"max":[{},{},{}]}})",
      add_view(std::as_bytes(points), kVertices), kFloat, points.size(), low[0], low[1], low[2], high[0],
      high[1], high[2]);
}

std::size_t GlbWriter::add_normals(std::span<const std::array<float, 3>> normals) {
  return accessors_.add(R"({{"bufferView":{},"componentType":{},"count":{},"type":"VEC3"}})",
                        add_view(std::as_bytes(normals), kVertices), kFloat, normals.size());
}

std::size_t GlbWriter::add_uv(std::span<const std::array<float, 2>> uv) {
  return accessors_.add(R"({{"bufferView":{},"componentType":{},"count":{},"type":"VEC2"}})",
                        add_view(std::as_bytes(uv), kVertices), kFloat, uv.size());
}

std::size_t GlbWriter::add_corners(std::span<const std::uint32_t> corners) {
  return accessors_.add(R"({{"bufferView":{},"componentType":{},"count":{},"type":"SCALAR"}})",
                        add_view(std::as_bytes(corners), kIndices), kUnsignedInt, corners.size());
}

std::size_t GlbWriter::add_image(const Image& image) {
  const Result<std::string> png = images::png_of(
      static_cast<int>(image.width), static_cast<int>(image.height), 4, image.rgba, images::PngEffort::kFast);
  const std::string bytes = png ? *png : std::string();
  const std::size_t row = images_.add(R"({{"bufferView":{},"mimeType":"image/png"}})",
                                      add_view(std::as_bytes(std::span(bytes)), kNoTarget));
  return textures_.add(R"({{"source":{}}})", row);
}

std::size_t GlbWriter::add_material(const Mesh& mesh, const Material& material, std::size_t first_texture) {
  const auto& base = material.base;
  const std::string texture =
      material.texture == Material::kNone
          ? ""
          : fmt::format(R"(,"baseColorTexture":{{"index":{}}})", first_texture + material.texture);
  const Light3& glow = material.emission;
  // The specification limits components to 1.
  const float most = std::max({glow[0], glow[1], glow[2], 1.0f});
  std::string rest;
  if (glow != Light3{0, 0, 0})
    rest += fmt::format(R"(,"emissiveFactor":[{},{},{}])", glow[0] / most, glow[1] / most, glow[2] / most);
  rest += alpha_mode(mesh, material);
  if (material.is_two_sided) rest += R"(,"doubleSided":true)";
  return materials.add(
      R"({{"pbrMetallicRoughness":{{"baseColorFactor":[{},{},{},{}],"metallicFactor":{},"roughnessFactor":{}{}}}{}}})",
      std::clamp(base[0], 0.0f, 1.0f), std::clamp(base[1], 0.0f, 1.0f), std::clamp(base[2], 0.0f, 1.0f),
      base[3], material.metallic, material.roughness, texture, rest);
}

std::size_t GlbWriter::add_mesh(const Mesh& mesh, const geom::Pose& X_FB) {
  const std::size_t first_texture = textures_.size(), first_material = materials.size();
  for (const Image& image : mesh.images) add_image(image);
  for (const Material& material : mesh.materials) add_material(mesh, material, first_texture);
  JsonList primitives;
  for (const Surface& surface : mesh.surfaces) {
    const std::span corners(surface.corners.front().data(), 3 * surface.corners.size());
    const std::size_t points = add_points(turned(surface.p, X_FB, false)),
                      normals = add_normals(turned(surface.normal, X_FB, true)), uv = add_uv(surface.uv);
    primitives.add(
        R"({{"attributes":{{"POSITION":{},"NORMAL":{},"TEXCOORD_0":{}}},"indices":{},"material":{}}})",
        points, normals, uv, add_corners(corners), first_material + surface.material);
  }
  return meshes.add(R"({{"primitives":[{}]}})", primitives.text());
}

std::string GlbWriter::file(std::string_view scene) {
  const auto array = [](std::string_view key, const JsonList& list) {  // empty arrays are invalid
    return list.size() == 0 ? "" : fmt::format(R"(,"{}":[{}])", key, list.text());
  };
  const std::string buffer =
      binary_.empty() ? "" : fmt::format(R"(,"buffers":[{{"byteLength":{}}}])", binary_.size());
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0","generator":"playhouse"}},{}{}{}{}{}{}{}{}}})", scene,
      array("meshes", meshes), array("materials", materials), array("textures", textures_),
      array("images", images_), array("accessors", accessors_), array("bufferViews", views_), buffer);
  std::string chunks;
  append_chunk(chunks, kJsonChunk, json, ' ');
  if (!binary_.empty()) append_chunk(chunks, kBinaryChunk, std::move(binary_), '\0');
  constexpr std::uint32_t kHeader = 12;
  std::string file;
  for (const std::uint32_t number : {kMagic, kVersion, kHeader + static_cast<std::uint32_t>(chunks.size())})
    append(file, number);
  return file + chunks;
}

std::string write_glb(const Mesh& mesh) {
  GlbWriter writer;
  const std::size_t row = writer.add_mesh(mesh, {});
  return writer.file(fmt::format(
      R"("scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":{},"rotation":[-0.7071067811865475,0,0,0.7071067811865476]}}])",
      row));
}

}  // namespace playhouse::mesh
