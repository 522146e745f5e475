#include "playhouse/mesh/fit.h"

#include <algorithm>

#include "playhouse/mesh/affine.h"
#include "playhouse/mesh/check_mesh.h"

namespace playhouse::mesh {
namespace {

using geom::Vec3;

/// p_B = stretch (p_F - middle).
struct Fit {
  Vec3 stretch{1, 1, 1}, middle;
  Vec3 scaled(const Vec3& v) const { return {stretch.x * v.x, stretch.y * v.y, stretch.z * v.z}; }
  Vec3 operator()(const Vec3& p) const { return scaled(p - middle); }
};

std::array<float, 3> floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
Vec3 vec(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

void fit(Surface& surface, const Fit& fit) {
  const Affine X{{{{fit.stretch.x, 0, 0}, {0, fit.stretch.y, 0}, {0, 0, fit.stretch.z}}}, {}};
  const Affine X_normal = for_normals(X);
  for (auto& p : surface.p) p = floats(fit(vec(p)));
  for (auto& normal : surface.normal) normal = floats(unit(X_normal.turn(vec(normal)), {0, 0, 1}));
}

void fit(Shape& shape, const Fit& fit) {
  shape.p = fit(shape.p);
  if (shape.kind == ShapeKind::kHull || shape.kind == ShapeKind::kTriangles) {
    // Point shapes from files are never rotated.
    for (Vec3& p : shape.points) p = fit.scaled(p);
    return;
  }
  const double x = length(fit.scaled(shape.q * Vec3{1, 0, 0})),
               y = length(fit.scaled(shape.q * Vec3{0, 1, 0})),
               z = length(fit.scaled(shape.q * Vec3{0, 0, 1}));
  if (shape.kind == ShapeKind::kBox) {
    shape.half = {x * shape.half.x, y * shape.half.y, z * shape.half.z};
  } else {
    const double across = shape.kind == ShapeKind::kSphere ? std::max({x, y, z}) : std::max(x, y);
    shape.half = {across * shape.half.x, across * shape.half.y,
                  (shape.kind == ShapeKind::kSphere ? across : z) * shape.half.z};
  }
}

}  // namespace

Mesh fitted(Mesh mesh, const Vec3& size) {
  const Vec3 extent = mesh.high - mesh.low;
  const auto ratio = [](double wanted, double is) { return is > 0 && wanted > 0 ? wanted / is : 1; };
  const Fit to{{ratio(size.x, extent.x), ratio(size.y, extent.y), ratio(size.z, extent.z)},
               {0.5 * (mesh.low.x + mesh.high.x), 0.5 * (mesh.low.y + mesh.high.y), mesh.low.z}};
  for (Surface& surface : mesh.surfaces) fit(surface, to);
  for (Light& light : mesh.lights) light.p = to(light.p);
  if (mesh.physics)
    for (Shape& shape : mesh.physics->shapes) fit(shape, to);
  measure(mesh);
  return mesh;
}

}  // namespace playhouse::mesh
