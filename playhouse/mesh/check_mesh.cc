#include "playhouse/mesh/check_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "playhouse/base/mesh_limits.h"

namespace playhouse::mesh {
namespace {

using geom::Vec3;

bool is_near(const Vec3& p) {
  return std::fabs(p.x) <= limits::kMeshReach && std::fabs(p.y) <= limits::kMeshReach &&
         std::fabs(p.z) <= limits::kMeshReach;  // false for NaN
}

template <typename List>
bool all_finite(const List& list) {
  return std::ranges::all_of(list, [](const auto& one) {
    return std::ranges::all_of(one, [](float x) { return std::isfinite(x); });
  });
}

template <typename Corners>
bool are_rows(const Corners& corners, std::size_t rows) {
  return std::ranges::all_of(corners, [rows](const auto& three) {
    return std::ranges::all_of(three, [rows](std::uint32_t row) { return row < rows; });
  });
}

Error too_many(std::string_view what, std::size_t most) {
  return {{}, fmt::format("has too many {}: up to {} are possible", what, most)};
}

Result<void> check_surface(const Surface& surface, const Mesh& mesh) {
  const std::size_t corners = surface.p.size();
  if (surface.normal.size() != corners || surface.uv.size() != corners ||
      surface.material >= mesh.materials.size() || !are_rows(surface.corners, corners))
    return Error{{}, "is broken: a triangle has a corner that is not there"};
  for (const auto& p : surface.p)
    if (!is_near({p[0], p[1], p[2]}))
      return Error{
          {}, fmt::format("is broken: a corner is not a number, or farther than {:g} m", limits::kMeshReach)};
  if (!all_finite(surface.normal) || !all_finite(surface.uv))
    return Error{{}, "is broken: a normal or a place on a texture is not a number"};
  return {};
}

Result<void> check_look(const Mesh& mesh) {
  std::size_t pixels = 0;
  for (const Image& image : mesh.images) {
    if (image.rgba.size() != std::size_t{4} * image.width * image.height)
      return Error{{}, "is broken: an image has the wrong number of pixels"};
    pixels += image.rgba.size() / 4;
  }
  if (mesh.images.size() > limits::kMeshImages) return too_many("textures", limits::kMeshImages);
  if (pixels > limits::kMeshPixels) return too_many("pixels of textures", limits::kMeshPixels);
  if (mesh.lights.size() > limits::kMeshLights) return too_many("lights", limits::kMeshLights);
  for (const Material& material : mesh.materials) {
    const bool has_texture = material.texture != Material::kNone;
    if (has_texture && material.texture >= mesh.images.size())
      return Error{{}, "is broken: a material has a texture that is not there"};
    if (!all_finite(std::span(&material.base, 1)) || !all_finite(std::span(&material.emission, 1)) ||
        !std::isfinite(material.metallic) || !std::isfinite(material.roughness) ||
        !std::isfinite(material.least_opacity))
      return Error{{}, "is broken: a color is not a number"};
  }
  for (const Light& light : mesh.lights)
    if (!is_near(light.p) || !is_near(light.d) || !all_finite(std::span(&light.color, 1)) ||
        !std::isfinite(light.inner) || !std::isfinite(light.outer))
      return Error{{}, "is broken: a light is not a number"};
  return {};
}

/// True if absent or a number from 0 to `most`.
bool is_within(const std::optional<double>& x, double most) {
  return !x || (*x >= 0 && *x <= most);
}

Result<void> check_physics(const PhysicalProperties& physics) {
  if (physics.shapes.size() > limits::kMeshShapes) return too_many("shapes for physics", limits::kMeshShapes);
  if (!is_within(physics.mass, limits::kMeshMass))
    return Error{
        {},
        fmt::format("is broken: its mass for physics is not a number from 0 to {:g} kg", limits::kMeshMass)};
  if (!is_within(physics.friction, limits::kMeshCoefficient) ||
      !is_within(physics.restitution, limits::kMeshCoefficient))
    return Error{
        {}, fmt::format("is broken: a coefficient is not a number from 0 to {:g}", limits::kMeshCoefficient)};
  std::size_t points = 0, triangles = 0;
  for (const CollisionShape& shape : physics.shapes) {
    points += shape.points.size();
    triangles += shape.corners.size();
    const geom::Quaternion& q = shape.q;
    const double norm = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const Vec3& half = shape.half;
    if (!is_near(shape.p) || !is_near(half) || !std::ranges::all_of(shape.points, is_near) ||
        !(std::fabs(norm - 1) < 1e-6) || half.x < 0 || half.y < 0 || half.z < 0)
      return Error{
          {},
          fmt::format("is broken: a shape for physics is not a number, or larger or farther than {:g} m",
                      limits::kMeshReach)};
    if (!are_rows(shape.corners, shape.points.size()))
      return Error{{}, "is broken: a shape for physics has a corner that is not there"};
  }
  if (points > limits::kMeshCorners) return too_many("corners of shapes for physics", limits::kMeshCorners);
  if (triangles > limits::kMeshTriangles)
    return too_many("triangles of shapes for physics", limits::kMeshTriangles);
  return {};
}

}  // namespace

Result<void> check_mesh(const Mesh& mesh) {
  std::size_t corners = 0, triangles = 0;
  for (const Surface& surface : mesh.surfaces) {
    corners += surface.p.size();
    triangles += surface.corners.size();
    if (const auto checked = check_surface(surface, mesh); !checked) return checked;
  }
  if (triangles == 0) return Error{{}, "has no triangles"};
  if (triangles > limits::kMeshTriangles) return too_many("triangles", limits::kMeshTriangles);
  if (corners > limits::kMeshCorners) return too_many("corners", limits::kMeshCorners);
  if (const auto checked = check_look(mesh); !checked) return checked;
  return mesh.physics ? check_physics(*mesh.physics) : Result<void>();
}

void measure(Mesh& mesh) {
  constexpr double kFar = 1e300;
  Vec3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  for (const Surface& surface : mesh.surfaces)
    for (const auto& p : surface.p) {
      low = {std::min<double>(low.x, p[0]), std::min<double>(low.y, p[1]), std::min<double>(low.z, p[2])};
      high = {std::max<double>(high.x, p[0]), std::max<double>(high.y, p[1]), std::max<double>(high.z, p[2])};
    }
  mesh.low = low;
  mesh.high = high;
}

}  // namespace playhouse::mesh
