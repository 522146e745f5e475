#include "playhouse/render/shape_store.h"

#include <algorithm>
#include <cmath>

#include "playhouse/mesh/opacity.h"

namespace playhouse::render {
namespace {

/// Bounding sphere about the centre of the bounding box.
void set_sphere(ShapeOnCard& shape, const mesh::Mesh& mesh) {
  geom::Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  const auto each = [&](const auto& visit) {
    for (const mesh::Surface& surface : mesh.surfaces)
      for (const auto& p : surface.p) visit(geom::Vec3{p[0], p[1], p[2]});
  };
  each([&](const geom::Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  });
  if (low.x > high.x) return;
  shape.middle = 0.5 * (low + high);
  each([&](const geom::Vec3& p) {
    const geom::Vec3 d = p - shape.middle;
    shape.radius = std::max(shape.radius, std::sqrt(dot(d, d)));
  });
}

SurfaceRange look_of(const mesh::Mesh& mesh, const mesh::Surface& surface,
                     const std::vector<std::uint32_t>& textures) {
  SurfaceRange range;
  if (surface.material >= mesh.materials.size()) return range;
  const mesh::Material& material = mesh.materials[surface.material];
  range.base = material.base;
  range.emission = material.emission;
  range.metallic = material.metallic;
  range.roughness = material.roughness;
  range.is_two_sided = material.is_two_sided;
  range.is_see_through = mesh::is_see_through(mesh, material);
  range.is_mirror = is_mirror(material) && !range.is_see_through;
  range.least_opacity = material.opacity == mesh::Opacity::kClear   ? -1
                        : material.opacity == mesh::Opacity::kHoles ? material.least_opacity
                                                                    : 0;
  if (material.texture < textures.size() && surface.uv.size() == surface.p.size())
    range.texture = textures[material.texture];
  return range;
}

bool is_invisible(const mesh::Mesh& mesh, const mesh::Surface& surface) {
  return surface.material < mesh.materials.size() && mesh::is_all_hole(mesh.materials[surface.material]);
}

}  // namespace

std::uint32_t ShapeStore::add(const mesh::Mesh& mesh) {
  ShapeOnCard shape;
  const std::vector<std::uint32_t> textures = add_images(mesh);
  set_sphere(shape, mesh);
  shape.mirrors = mirror_faces(mesh);
  has_mirrors_ = has_mirrors_ || !shape.mirrors.empty();
  for (const mesh::Surface& surface : mesh.surfaces) {
    if (surface.corners.empty() || is_invisible(mesh, surface)) continue;
    SurfaceRange range = look_of(mesh, surface, textures);
    range.first_index = static_cast<std::uint32_t>(indices_.size());
    range.first_corner = static_cast<std::uint32_t>(corners_.size() * sizeof(float) / kCornerBytes);
    const bool has_uv = surface.uv.size() == surface.p.size();
    for (std::size_t i = 0; i < surface.p.size(); ++i) {
      const auto& p = surface.p[i];
      const auto& n = i < surface.normal.size() ? surface.normal[i] : std::array<float, 3>{0, 0, 1};
      const auto uv = has_uv ? surface.uv[i] : std::array<float, 2>{0, 0};
      corners_.insert(corners_.end(), {p[0], p[1], p[2], n[0], n[1], n[2], uv[0], uv[1]});
    }
    for (const auto& corner : surface.corners) indices_.insert(indices_.end(), corner.begin(), corner.end());
    range.indices = static_cast<std::uint32_t>(indices_.size()) - range.first_index;
    shape.surfaces.push_back(range);
  }
  shapes_.push_back(std::move(shape));
  is_sent_ = false;
  return static_cast<std::uint32_t>(shapes_.size() - 1);
}

/// OpenGL names of the textures, 0 for unusable ones.
std::vector<std::uint32_t> ShapeStore::add_images(const mesh::Mesh& mesh) {
  std::vector<std::uint32_t> names;
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  for (const mesh::Image& image : mesh.images) {
    const std::uint32_t longest = std::max(image.width, image.height);
    const std::size_t bytes = std::size_t{4} * image.width * image.height;
    if (longest == 0 || longest > static_cast<std::uint32_t>(most) || image.rgba.size() != bytes) {
      names.push_back(0);
      continue;
    }
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    Texture texture(name);
    const auto width = static_cast<GLsizei>(image.width), height = static_cast<GLsizei>(image.height);
    glTextureStorage2D(texture, 1 + static_cast<GLsizei>(std::log2(longest)), GL_SRGB8_ALPHA8, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    glGenerateTextureMipmap(texture);
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    names.push_back(texture);
    textures_.push_back(std::move(texture));
  }
  return names;
}

void ShapeStore::upload() {
  if (is_sent_) return;
  corner_buffer_.set(std::span<const float>(corners_), GL_STATIC_DRAW);
  index_buffer_.set(std::span<const std::uint32_t>(indices_), GL_STATIC_DRAW);
  is_sent_ = true;
}

void FigureStore::upload() {
  std::vector<float> corners;
  std::vector<std::uint32_t> indices;
  for (int number = 0; number < kHumanoidLevels; ++number) {
    const Humanoid humanoid = make_humanoid(number);
    DetailLevel& level = levels_[static_cast<std::size_t>(number)];
    level.first_index = static_cast<std::uint32_t>(indices.size());
    level.first_corner = static_cast<std::uint32_t>(corners.size() * sizeof(float) / kCornerBytes);
    for (const Humanoid::Corner& corner : humanoid.corners) {
      corners.insert(corners.end(), corner.p.begin(), corner.p.end());
      corners.insert(corners.end(), corner.normal.begin(), corner.normal.end());
      corners.insert(corners.end(), corner.paint.begin(), corner.paint.end());
      corners.insert(corners.end(), {static_cast<float>(corner.bone[0]), static_cast<float>(corner.bone[1]),
                                     corner.share, 0});
    }
    for (const auto& triangle : humanoid.triangles)
      indices.insert(indices.end(), triangle.begin(), triangle.end());
    level.indices = static_cast<std::uint32_t>(indices.size()) - level.first_index;
  }
  corner_buffer_.set(std::span<const float>(corners), GL_STATIC_DRAW);
  index_buffer_.set(std::span<const std::uint32_t>(indices), GL_STATIC_DRAW);
}

}  // namespace playhouse::render
